//! 256 colours for a picture of many: boxes of colours are halved where the most is lost.
//!
//! Colours are counted in cells of 4 steps each way. A box of cells is cut at its mean along the channel in which its
//! colours differ the most; the box with the largest sum of squares of differences is cut next. Each box gives its
//! mean to all of its cells. Source: docs/REFERENCES.md, Heckbert 1982.

/// Colours of a palette at the most.
const MOST: usize = 256;
/// Bits of a channel that tell cells apart.
const BITS: u32 = 6;

/// A palette, and which of its colours each cell has.
#[derive(Debug, Clone)]
pub(super) struct Palette {
    /// Red, green and blue of each colour.
    pub(super) colors: Vec<u8>,
    of_cell: Vec<u8>,
}

/// A cell that has colours.
#[derive(Debug, Clone, Copy)]
struct Cell {
    key: usize,
    count: f64,
    mean: [f64; 3],
}

fn key([r, g, b]: [u8; 3]) -> usize {
    let cut = |channel: u8| usize::from(channel) >> (8 - BITS);
    (cut(r) << (2 * BITS)) | (cut(g) << BITS) | cut(b)
}

/// What a box of cells has in common.
struct Group {
    cells: Vec<Cell>,
    mean: [f64; 3],
    /// Sum of squares of differences from the mean, by channel.
    spread: [f64; 3],
}

impl Group {
    fn of(cells: Vec<Cell>) -> Self {
        let count: f64 = cells.iter().map(|cell| cell.count).sum();
        let mean = std::array::from_fn(|channel| {
            cells.iter().map(|cell| cell.count * cell.mean[channel]).sum::<f64>() / count.max(1.0)
        });
        let square = |cell: &Cell, channel: usize| {
            let apart: f64 = cell.mean[channel] - mean[channel];
            cell.count * apart * apart
        };
        let spread = std::array::from_fn(|channel| cells.iter().map(|cell| square(cell, channel)).sum());
        Self { cells, mean, spread }
    }

    fn lost(&self) -> f64 {
        if self.cells.len() < 2 { 0.0 } else { self.spread.iter().sum() }
    }

    /// Cut at its mean along the channel in which its colours differ the most.
    fn halves(self) -> [Self; 2] {
        let channel = (0..3).max_by(|&a, &b| self.spread[a].total_cmp(&self.spread[b])).unwrap_or(0);
        let at = self.mean[channel];
        let (low, high) = self.cells.into_iter().partition(|cell| cell.mean[channel] <= at);
        [Self::of(low), Self::of(high)]
    }
}

impl Palette {
    /// Of a picture.
    pub(super) fn of(rgb: &[u8]) -> Self {
        let mut sums = vec![[0_u32; 4]; 1 << (3 * BITS)];
        for color in rgb.chunks_exact(3) {
            let sum = &mut sums[key([color[0], color[1], color[2]])];
            for (channel, value) in color.iter().enumerate() {
                sum[channel] += u32::from(*value);
            }
            sum[3] += 1;
        }
        let is_there = sums.iter().enumerate().filter(|(_, sum)| sum[3] > 0);
        let cells = is_there.map(|(key, sum)| {
            let count = f64::from(sum[3]);
            Cell { key, count, mean: [0, 1, 2].map(|channel: usize| f64::from(sum[channel]) / count) }
        });
        let mut groups = vec![Group::of(cells.collect())];
        while groups.len() < MOST {
            let lost = groups.iter().enumerate().max_by(|(_, a), (_, b)| a.lost().total_cmp(&b.lost()));
            let Some((place, _)) = lost.filter(|(_, group)| group.lost() > 0.0) else { break };
            let halves = groups.swap_remove(place).halves();
            groups.extend(halves.into_iter().filter(|group| !group.cells.is_empty()));
        }
        let mut palette = Self { colors: Vec::with_capacity(3 * MOST), of_cell: vec![0; 1 << (3 * BITS)] };
        for (number, group) in groups.iter().enumerate() {
            palette.colors.extend(group.mean.map(|channel| channel.round() as u8));
            for cell in &group.cells {
                palette.of_cell[cell.key] = number as u8;
            }
        }
        palette
    }

    /// The number of the colour that stands for one of the picture.
    pub(super) fn number_of(&self, color: [u8; 3]) -> u8 {
        self.of_cell[key(color)]
    }
}

#[cfg(test)]
mod tests {
    //! Few colours are kept, and of many each is near to the one that stands for it.
    use super::*;

    fn shown(palette: &Palette, color: [u8; 3]) -> [u8; 3] {
        let at = 3 * usize::from(palette.number_of(color));
        [palette.colors[at], palette.colors[at + 1], palette.colors[at + 2]]
    }

    #[test]
    fn few_colours_are_kept() {
        let colors = [[238, 241, 244], [86, 146, 204], [0, 0, 0], [255, 255, 255]];
        let palette = Palette::of(colors.as_flattened());
        assert!(colors.iter().all(|&color| shown(&palette, color) == color));
    }

    #[test]
    fn many_colours_are_near() {
        let ramp: Vec<[u8; 3]> = (0..=255).flat_map(|a: u8| (0..16).map(move |b: u8| [a, 255 - a, b * 16])).collect();
        let palette = Palette::of(ramp.as_flattened());
        assert!(palette.colors.len() <= 3 * MOST);
        for color in ramp {
            let apart = shown(&palette, color).iter().zip(color).map(|(a, b)| a.abs_diff(b)).max();
            assert!(apart < Some(24), "{color:?} {apart:?}");
        }
    }
}
