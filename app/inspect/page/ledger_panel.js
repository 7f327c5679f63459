// The flux ledger of each light.

class LedgerPanel {
  constructor(page) {
    this.page = page;
    this.element = make("div", {class: "panel ledger-panel"});
  }

  show() {
    const run = this.page.run();
    const parts = run.lights.flatMap((light) => this.lightParts(light));
    this.element.replaceChildren(...parts.length ? parts : [paragraph("This run has no light.")]);
  }

  lightParts(light) {
    const head = make("h2", {}, `Where the light of ${light.name} goes`);
    if (!light.ledger) return [head, paragraph("This light has no ledger: it throws no caustic here.")];
    const entered = light.ledger.find((entry) => entry.account === "entered");
    const total = luminance(entered?.flux);
    const others = light.ledger.filter((entry) => entry !== entered)
      .map((entry) => ({...entry, share: total > 0 ? luminance(entry.flux) / total : 0}))
      .sort((a, b) => b.share - a.share);
    const some = others.filter((entry) => entry.share > 0);
    const none = others.filter((entry) => !(entry.share > 0));
    const text = `${formatNumber(total)} ${light.flux_unit ?? ""}`;
    return [head,
      make("div", {class: "ledger-box"}, ledgerDiagram(text, some, `Flux of ${light.name}, by account`)),
      none.length ? paragraph(`Nothing went to: ${none.map((entry) => plainName(entry.account)).join(", ")}.`) : null,
      this.sumParagraph(total, others), this.errorParagraph(light),
      folded("All accounts in numbers", this.numbers(light, total))].filter(Boolean);
  }

  // Books that balance to rounding.
  sumParagraph(total, others) {
    const rest = total - others.reduce((flux, entry) => flux + entry.share * total, 0);
    return paragraph(`Shares are of luminance. The accounts add up to what entered` +
      (Math.abs(rest) > 1e-5 * total ? `, but for ${formatShare(rest / total)}.` : "."));
  }

  errorParagraph(light) {
    const stated = Object.entries(light.estimated_error ?? {}).filter(([, value]) => typeof value === "number");
    if (!stated.length) return null;
    return paragraph("Stated error of its caustic: ", stated.map(([name, value]) => `${plainName(name)} ${formatShare(value)}`).join(", "), ".");
  }

  numbers(light, total) {
    return table(["account", "share", "red", "green", "blue", "meaning"], light.ledger.map(({account, flux, meaning}) =>
      [plainName(account), formatShare(luminance(flux) / total), ...[0, 1, 2].map((c) => formatNumber(flux?.[c], 5)), meaning]));
  }

  views() {
    return [];
  }
}

function luminance(flux) {
  return flux ? brightness(flux, 0, flux.length) : 0;
}
