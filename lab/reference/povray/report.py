"""What a comparison says: tables, seconds for equal errors, a picture of the differences."""
import math

import pictures

LEVELS = (0.2, 0.1, 0.05, 0.03, 0.02, 0.015, 0.01, 0.005)
PROGRAMS = 'caustics', 'POV-Ray'


def front(rows, box, clock):
    """(error, seconds) of the settings that no quicker one beats, from coarse to fine."""
    best = []
    for row in sorted(rows, key=lambda r: r[clock]):
        if not best or row['raw'][box] < best[-1][0]:
            best.append((row['raw'][box], row[clock]))
    return best


def seconds_for(points, error):
    """Seconds for this error, between measured settings by straight lines in the logarithms of both. A bound
    where the quickest setting is better already; None where no setting is as good."""
    if points[0][0] <= error:
        return {'seconds': points[0][1], 'bound': True}
    for (e0, t0), (e1, t1) in zip(points, points[1:]):
        if e1 <= error:
            share = math.log(e0 / error) / math.log(e0 / e1)
            return {'seconds': t0 * (t1 / t0) ** share, 'bound': False}
    return None


def equal_error(rows, box):
    """Seconds of both by both clocks, for each level that one of them reaches and does not undercut from the
    start."""
    def seconds(who, clock, level):
        return seconds_for(front([r for r in rows if r['program'] == who], box, clock), level)

    table = [{'error': level, **{who: {clock: seconds(who, clock, level) for clock in ('wall', 'cpu')}
                                 for who in PROGRAMS}} for level in LEVELS]
    found = [[row[who]['wall'] for who in PROGRAMS] for row in table]
    return [row for row, walls in zip(table, found) if any(wall and not wall['bound'] for wall in walls)]


def told(found):
    return '-' if found is None else ('< ' if found['bound'] else '') + '%.2f' % found['seconds']


def print_tables(result, boxes):
    exact = f", '{result['exact']}' as an exact sphere" if result['exact'] else ''
    direct = result['direct']
    print(f"\n## {result['scene']}{exact}, physics {result['physics']}\n")
    said = 'none in view'
    if direct:
        said = (f"{direct['ratio']:.4f}, over the {100 * direct['lit_share']:.0f}% of the floor that both "
                'light')
    print(f'Direct light, POV-Ray / caustics: {said}. Noise of the truth: ' +
          ', '.join(f'{result["truth_noise"][b]:.4f} in boxes of {b} x {b}' for b in boxes) + '.\n')
    print('| program | setting | wall s | cpu s | flux ratio | ' +
          ' | '.join(f'L1 {b} x {b} | flux scaled' for b in boxes) + ' |')
    print('|---|---|---|---|---|' + '---|---|' * len(boxes))
    for row in result['rows']:
        errors = ' | '.join(f"{row['raw'][b]:.4f} | {row['scaled'][b]:.4f}" for b in boxes)
        print(f"| {row['program']} | {row['setting']} | {row['wall']:.2f} | {row['cpu']:.2f} | "
              f"{row['flux']:.4f} | {errors} |")
    clocks = ' | '.join(f'{who}, wall s | cpu s' for who in PROGRAMS)
    print(f'\n| relative L1, {boxes[0]} x {boxes[0]} | {clocks} |\n|---|---|---|---|---|')
    for row in result['equal_error']:
        seconds = ' | '.join(told(row[who][clock]) for who in PROGRAMS for clock in ('wall', 'cpu'))
        print(f"| {row['error']} | {seconds} |")


def write_difference(bench, settings, path):
    """Above: truth, caustics, POV-Ray, each at its last setting; below, where they have too much light (red)
    or too little (blue), pure at a fifth of what is white above."""
    side = bench.arguments.boxes[0]
    truth = bench.truth.boxes[side]
    shown = [bench.caustic([s for s in settings if s.program == who][-1]).boxes(side) for who in PROGRAMS]
    white = sorted(max(pixel) for pixel in zip(*truth.planes))[int(0.98 * truth.size ** 2)]
    pictures.write_png(path, truth.size, [[pictures.exposed(p, white) for p in (truth, *shown)],
                                          [None, *(pictures.signed(p.minus(truth), 0.2 * white)
                                                   for p in shown)]])
