// Keys of the whole page. Controls that use a key themselves keep it.

const kArrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};

function listenToKeys(page) {
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || page.help.open) return;
    if (event.target.closest?.("input, select, textarea")) return;
    if (useKey(page, event)) event.preventDefault();
  });
}

function useKey(page, event) {
  const panel = page.panel();
  const arrow = kArrows[event.key];
  if (arrow && event.shiftKey) return Boolean(panel.moveTexel?.(arrow[0], -arrow[1]) ?? true);
  if (arrow) return Boolean(panel.step?.(...arrow) ?? true);
  const images = panel.views().map((view) => view.image);
  switch (event.key) {
    case "+": case "=": zoomAll(images, 1.5); return true;
    case "-": case "_": zoomAll(images, 1 / 1.5); return true;
    case "0": for (const image of images) image.reset(); return true;
    case "[": for (const view of panel.views()) view.expose(-0.5); return true;
    case "]": for (const view of panel.views()) view.expose(0.5); return true;
    case "?": page.help.showModal(); return true;
    case "p": case "P": page.toggleProjector(); return true;
  }
  const number = Number(event.key) - 1;
  if (!(number in kPanels)) return false;
  page.set({panel: kPanels[number].id});
  return true;
}

// The one that has the focus, else all; linked ones follow by themselves.
function zoomAll(images, factor) {
  const focused = images.filter((image) => image.element.contains(document.activeElement));
  const chosen = focused.length ? focused : images;
  const linked = chosen.some((image) => image.peers?.length);
  for (const image of linked ? chosen.slice(0, 1) : chosen) image.zoomBy(factor);
}
