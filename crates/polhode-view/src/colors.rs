//! Colours of bodies in pictures and models.

/// Red, green and blue as light: linear, 0 to 1.
pub(crate) type Color = [f64; 3];

/// Colours of bodies that move, told apart by people who see few colours (after Okabe and Ito), as sRGB.
const MOVING: [[u8; 3]; 7] =
    [[86, 146, 204], [230, 159, 60], [60, 165, 125], [214, 105, 60], [204, 130, 172], [226, 208, 80], [128, 128, 200]];

/// Colour of bodies that do not move, as sRGB.
const STANDING: [u8; 3] = [176, 178, 182];

/// The colour of a body by its number among those that move; of one that does not, without.
pub(crate) fn body(number: Option<usize>) -> Color {
    linear(number.map_or(STANDING, |number| MOVING[number % MOVING.len()]))
}

/// sRGB as light.
pub(crate) fn linear(srgb: [u8; 3]) -> Color {
    srgb.map(|channel| {
        let c = f64::from(channel) / 255.0;
        if c <= 0.04045 { c / 12.92 } else { libm::pow((c + 0.055) / 1.055, 2.4) }
    })
}

/// Light as sRGB.
pub(crate) fn srgb(light: Color) -> [u8; 3] {
    light.map(|channel| {
        let c = channel.clamp(0.0, 1.0);
        let c = if c <= 0.003_130_8 { 12.92 * c } else { 1.055 * libm::pow(c, 1.0 / 2.4) - 0.055 };
        (255.0 * c).round() as u8
    })
}
