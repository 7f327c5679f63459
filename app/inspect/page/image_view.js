// A picture that can be zoomed and moved, with marks on it. Texel (0, 0) is at the bottom left. Knows nothing of
// what the picture means. Zoomed in it shows texels as squares.

const kMostZoom = 96;

class ImageView {
  // `handlers`: hover(x, y) or hover(null), pick(x, y), moved().
  constructor(label, handlers = {}) {
    this.handlers = handlers;
    this.canvas = make("canvas", {class: "view", tabindex: 0, role: "img", "aria-label": label});
    this.element = make("div", {class: "view-frame"}, this.canvas);
    this.source = document.createElement("canvas");
    this.marks = [];
    this.peers = [];
    this.fitted = true;
    this.scale = 1;
    this.left = this.top = 0;
    this.listen();
    new ResizeObserver(() => this.resize()).observe(this.element);
  }

  setImage(image) {
    const changed = this.source.width !== image.width || this.source.height !== image.height;
    if (changed) [this.source.width, this.source.height] = [image.width, image.height];
    this.source.getContext("2d").putImageData(image, 0, 0);
    this.empty = false;
    if (changed) this.resize();
    if (changed || this.fitted) this.fit();
    this.redraw();
  }

  clear() {
    this.empty = true;
    this.redraw();
  }

  // Each: {x0, y0, x1, y1 in texels, color, fill, label}.
  setMarks(marks) {
    this.marks = marks;
    this.redraw();
  }

  // Views linked so move together, as long as their pictures are of one size.
  static linkAll(views) {
    for (const view of views) view.peers = views.filter((other) => other !== view);
  }

  resize() {
    const ratio = window.devicePixelRatio || 1;
    const {width, height} = this.element.getBoundingClientRect();
    if (!width || !height) return;
    // No higher than the picture is when it fills the width: what stands below follows at once.
    if (this.source.height) this.element.style.maxHeight = `${width * this.source.height / this.source.width}px`;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    if (this.fitted) this.fit();
    this.redraw();
  }

  fit() {
    const scale = Math.min(this.canvas.width / this.source.width, this.canvas.height / this.source.height);
    this.scale = scale > 0 && Number.isFinite(scale) ? scale : 1;
    this.left = this.top = 0;
    this.fitted = true;
    this.redraw();
  }

  reset() {
    this.fit();
    for (const peer of this.peers) peer.fit();
  }

  zoomBy(factor, x = this.canvas.width / 2, y = this.canvas.height / 2) {
    const fit = Math.min(this.canvas.width / this.source.width, this.canvas.height / this.source.height);
    const scale = clamp(this.scale * factor, fit / 4, Math.max(kMostZoom, fit * 4));
    this.left = x - (x - this.left) * scale / this.scale;
    this.top = y - (y - this.top) * scale / this.scale;
    this.scale = scale;
    this.moved();
  }

  moved() {
    this.fitted = false;
    for (const peer of this.peers) {
      if (peer.source.width !== this.source.width || peer.canvas.width !== this.canvas.width) continue;
      Object.assign(peer, {left: this.left, top: this.top, scale: this.scale, fitted: false});
      peer.redraw();
    }
    this.redraw();
  }

  // Brings a rectangle of texels into the middle, at least `side` screen pixels a texel.
  centerOn(x, y, side = 0) {
    if (side > this.scale) this.scale = side;
    this.left = this.canvas.width / 2 - this.scale * (x + 0.5);
    this.top = this.canvas.height / 2 - this.scale * (this.source.height - y - 0.5);
    this.moved();
  }

  shows(x, y) {
    const [sx, sy] = this.screenOf(x + 0.5, y + 0.5);
    return sx >= 0 && sy >= 0 && sx < this.canvas.width && sy < this.canvas.height;
  }

  screenOf(x, y) {
    return [this.left + this.scale * x, this.top + this.scale * (this.source.height - y)];
  }

  texelAt(event) {
    const box = this.canvas.getBoundingClientRect();
    const ratio = this.canvas.width / box.width;
    const x = Math.floor(((event.clientX - box.left) * ratio - this.left) / this.scale);
    const row = Math.floor(((event.clientY - box.top) * ratio - this.top) / this.scale);
    const y = this.source.height - 1 - row;
    return x >= 0 && y >= 0 && x < this.source.width && y < this.source.height ? [x, y] : null;
  }

  listen() {
    const canvas = this.canvas;
    let drag = null;
    canvas.addEventListener("pointerdown", (event) => {
      drag = {x: event.clientX, y: event.clientY, left: this.left, top: this.top, moved: false};
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("pointermove", (event) => {
      if (drag) this.drag(drag, event);
      const texel = this.texelAt(event);
      this.handlers.hover?.(...(texel ?? [null, null]));
    });
    canvas.addEventListener("pointerup", (event) => {
      const texel = this.texelAt(event);
      if (drag && !drag.moved && texel) this.handlers.pick?.(...texel);
      drag = null;
    });
    canvas.addEventListener("pointerleave", () => this.handlers.hover?.(null, null));
    canvas.addEventListener("wheel", (event) => this.wheel(event), {passive: false});
  }

  drag(start, event) {
    const ratio = this.canvas.width / this.canvas.getBoundingClientRect().width;
    const [dx, dy] = [event.clientX - start.x, event.clientY - start.y];
    // A hand is never quite still when it clicks.
    if (!start.moved && Math.hypot(dx, dy) < 4) return;
    start.moved = true;
    this.left = start.left + dx * ratio;
    this.top = start.top + dy * ratio;
    this.moved();
  }

  wheel(event) {
    event.preventDefault();
    const box = this.canvas.getBoundingClientRect();
    const ratio = this.canvas.width / box.width;
    const step = event.deltaMode === 1 ? event.deltaY * 30 : event.deltaY;
    this.zoomBy(Math.exp(-step / 400), (event.clientX - box.left) * ratio, (event.clientY - box.top) * ratio);
  }

  redraw() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.draw();
    });
  }

  draw() {
    const context = this.canvas.getContext("2d");
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    if (this.empty || !this.source.width) return;
    context.imageSmoothingEnabled = this.scale < 1;
    context.imageSmoothingQuality = "medium";
    const box = [this.left, this.top, this.scale * this.source.width, this.scale * this.source.height];
    context.drawImage(this.source, ...box);
    context.lineWidth = 1;
    context.strokeStyle = "#8888";
    context.strokeRect(...box);
    for (const mark of this.marks) this.drawMark(context, mark);
  }

  // Small marks grow to a size that can be seen. Outlines are dark outside and bright inside, to show on anything.
  drawMark(context, mark) {
    let [left, bottom] = this.screenOf(mark.x0, mark.y0);
    let [right, top] = this.screenOf(mark.x1, mark.y1);
    if (mark.fill) {
      context.globalAlpha = mark.fill;
      context.fillStyle = mark.color;
      context.fillRect(left, top, Math.max(right - left, 1.5), Math.max(bottom - top, 1.5));
      context.globalAlpha = 1;
    }
    if (mark.outline === false) return;
    const grow = Math.max(0, (10 - (right - left)) / 2);
    [left, top, right, bottom] = [left - grow, top - grow, right + grow, bottom + grow];
    for (const [width, style] of [[5, "#000"], [2.5, mark.color]]) {
      context.lineWidth = width;
      context.strokeStyle = style;
      context.strokeRect(left, top, right - left, bottom - top);
    }
  }
}
