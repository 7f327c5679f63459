// Where a light's flux went: one bar of what entered, bands to each account as wide as its share. Names stand beside,
// moved apart where bands are thin.

const kLedgerWidth = 900, kLedgerTop = 34, kFlowHeight = 300, kLabelStep = 40;
const kFlow = {from: 40, enter: 70, leave: 430, end: 450, text: 476};

// `accounts`: [{account, meaning, share}], the shares of what entered, largest first.
function ledgerDiagram(entered, accounts, title) {
  const rows = placed(accounts);
  const height = Math.max(kLedgerTop + kFlowHeight, rows.at(-1)?.middle ?? 0) + 40;
  return draw("svg", {class: "ledger", viewBox: `0 0 ${kLedgerWidth} ${height}`, role: "img", "aria-label": title},
    draw("text", {class: "ledger-name", x: kFlow.from, y: 22}, `entered ${entered}`),
    draw("rect", {class: "entered", x: kFlow.from, y: kLedgerTop, width: kFlow.enter - kFlow.from, height: kFlowHeight}),
    rows.map((row, number) => ledgerRow(row, number)));
}

function placed(accounts) {
  let from = kLedgerTop, next = kLedgerTop;
  return accounts.map((account) => {
    const size = Math.max(kFlowHeight * account.share, 0.75);
    const room = Math.max(size + 8, kLabelStep);
    const middle = next + room / 2;
    const row = {...account, from, size, middle, top: middle - size / 2};
    from += kFlowHeight * account.share;
    next += room;
    return row;
  });
}

function ledgerRow({account, meaning, share, from, size, top, middle}, number) {
  const color = kNamed[1 + number % (kNamed.length - 1)];
  const half = (kFlow.enter + kFlow.leave) / 2;
  const band = `M${kFlow.enter} ${from}C${half} ${from}, ${half} ${top}, ${kFlow.leave} ${top}` +
    `V${top + size}C${half} ${top + size}, ${half} ${from + size}, ${kFlow.enter} ${from + size}Z`;
  return draw("g", {class: "account"}, draw("title", {}, `${plainName(account)}, ${formatShare(share)}: ${meaning}`),
    draw("path", {class: "band", d: band, fill: color}),
    draw("rect", {x: kFlow.leave, y: top, width: kFlow.end - kFlow.leave, height: size, fill: color}),
    draw("text", {class: "ledger-name", x: kFlow.text, y: middle - 2}, `${plainName(account)}  ${formatShare(share)}`),
    draw("text", {class: "ledger-meaning", x: kFlow.text, y: middle + 16}, meaning));
}

// "total_reflection" as a person would write it.
function plainName(account) {
  return account.replaceAll("_", " ");
}
