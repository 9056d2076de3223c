// Canvases for plots: sharp on dense screens, dragged to choose a time.

/** Fits a canvas's pixels to its place in the page; returns its pen and its size in CSS pixels. */
export function fitCanvas(canvas) {
  const dense = Math.min(3, devicePixelRatio || 1);
  const { clientWidth: width, clientHeight: height } = canvas;
  if (canvas.width !== Math.round(width * dense) || canvas.height !== Math.round(height * dense)) {
    canvas.width = Math.round(width * dense);
    canvas.height = Math.round(height * dense);
  }
  const pen = canvas.getContext('2d');
  pen.setTransform(dense, 0, 0, dense, 0, 0);
  return { pen, width, height };
}

/** Calls chosen(x) with the CSS pixels from the left edge while the canvas is pressed or dragged. */
export function onDrag(canvas, chosen) {
  const tell = (event) => chosen(event.clientX - canvas.getBoundingClientRect().left);
  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    tell(event);
  });
  canvas.addEventListener('pointermove', (event) => {
    if (canvas.hasPointerCapture(event.pointerId)) tell(event);
  });
}
