"""The operators that make a fault of a place in a text: each yields (kind, begin, end, fault) of a
SourceText. A fault that ends with `;` takes the place of a statement, any other that of an expression. What
cannot show, or only in time and memory, is kept out here, by rules and not by name."""
import functools
import re

from faults import ROOT
from source_text import PRECEDENCE

RELATIONS = {'<': '>=', '>': '<=', '<=': '>', '>=': '<', '==': '!=', '!=': '==', '===': '!==', '!==': '==='}
BOUNDARIES = {'<': '<=', '>': '>=', '<=': '<', '>=': '>'}
ARITHMETIC = {'+': '-', '-': '+', '*': '/', '/': '*'}
COMPOUND = {'+=': '-=', '-=': '+=', '*=': '/=', '/=': '*=', '|=': '&='}
# Of calls that take the same values in either order, a swap changes nothing.
SYMMETRIC = {'min', 'max', 'min_of', 'max_of', 'dot', 'dot_of', 'hypot', 'std::min', 'std::max', 'glm::dot',
             'glm::min', 'glm::max',
             'exact::dot',
             'swap', 'std::swap', 'distance', 'glm::distance', 'Math.min', 'Math.max', 'Math.hypot', 'gcd'}
# What a statement or a number like these changes is time or memory, never what comes out.
COST_ONLY = re.compile(r'reserve\(|shrink_to_fit|\bassert|std::move|notify|\block|\bjoin\(|flush|'
                       r'prefetch|\bgrain|kGrain|[Tt]hread|[Pp]oll|[Ss]leep|yield|cache|'
                       r'kBlock\b|kPiece|malloc|\bcompressed\(|'
                       r'timeout|deadline|\(void\)|clear\(\)|'
                       r'\.close\(\)|unlink|addEventListener|[Ss]topwatch|capacity')
NUMBER = re.compile(r'(?<![\w.#"\'])(?:0x[0-9a-fA-F]+|\d+\.\d*(?:e[-+]?\d+)?|'
                    r'\d+(?:e-?\d+)?)(?P<suffix>[fFuUlL]*)(?![\w."\'])')
COUNTS = re.compile(r'^(?:\d+[uU]?|[ijkn]|\w*(?:count|index|size|width|height|level|depth)\w*|'
                    r'.*\.(?:size\(\)|length)|.*count\(\))$')


def whole(source, span):
    return source.text[span[0]:span[1]]


def has_text(source, *spans):
    return any('"' in source.masked[begin:end] for begin, end in spans)


def binary(source):
    for i, token in enumerate(source.tokens):
        sign = token.group()
        if sign not in PRECEDENCE:
            continue
        left, right = source.operands(i)
        a, b = whole(source, left), whole(source, right)
        if not a or not b:
            continue
        span = (left[0], right[1])
        if sign in RELATIONS:
            # A neighbour's own comparison would bind otherwise.
            yield ('relation', *span, f'{a} {RELATIONS[sign]} {b}')
            if sign in BOUNDARIES and (COUNTS.match(a) or COUNTS.match(b)):
                yield ('boundary', *span, f'{a} {BOUNDARIES[sign]} {b}')
        elif sign in ('&&', '||'):
            yield ('logic', *span, f'({a}) {"||" if sign == "&&" else "&&"} ({b})')
            yield ('condition left out', *span, f'static_cast<bool>({a})' if source.language == 'cpp' else a)
        elif sign in ARITHMETIC and not has_text(source, left, right):
            yield ('arithmetic', *span, f'{a} {ARITHMETIC[sign]} {b}')
            yield ('operand left out', *span, a)


@functools.lru_cache(maxsize=None)
def named_numbers():
    """The constants of C++ and of the page that are single numbers."""
    kinds = r'(?:int|float|double|std::(?:size_t|u?int\d+_t)|const) (k[A-Z]\w*) = [-\d(s.]'
    files = [path for top in ('app', 'lab', 'pipeline', 'passes', 'raster', 'gl_backend')
             for path in (ROOT / top).rglob('*') if path.suffix in ('.cpp', '.hpp', '.js')]
    return {name for path in files for name in re.findall(kinds, path.read_text())}


def numbers(source):
    for match in NUMBER.finditer(source.masked):
        text, suffix = match.group(), match.group('suffix')
        digits = text[:len(text) - len(suffix)]
        before = source.masked[:match.start()].rstrip()[-1:]
        size = before == '[' and re.match(r'\][\w\s]*(?:[;={]|\[)', source.masked[match.end():].lstrip())
        is_pure = re.search(r'\)[\w\s]*= $', source.masked[:match.start()])
        is_label = re.search(r'\bcase\s*$', source.masked[:match.start()])
        if 'x' in digits or before in '<' or size or is_pure or is_label:
            continue
        value = float(digits)
        if '.' in digits or 'e' in digits:
            changed = repr(value * 1.25 + (0.25 if value == 0 else 0))
        else:
            changed = str(int(value) + 1)
        yield ('constant', *match.span(), changed + suffix)
    for match in re.finditer(r'\b(?:true|false)\b', source.masked):
        yield ('constant', *match.span(), 'false' if match.group() == 'true' else 'true')
    if source.language != 'glsl':
        for match in re.finditer(r'(?<![\w.:])k[A-Z]\w*\b(?!\s*[(:{\[.])', source.masked):
            if match.group() not in named_numbers() or re.search(r'[<\[]$', source.masked[:match.start()]):
                continue
            yield ('constant', *match.span(), f'{match.group()} + {match.group()} / 4 + 1')


def conditions(source):
    for match in re.finditer(r'\bif \((?=\S)', source.masked):
        i = source.index.get(match.end() - 1)
        if i in source.partner:
            span = source.stripped(match.end(), source.tokens[source.partner[i]].start())
            if not re.search(r';|(?<![=!<>])=(?!=)', source.masked[slice(*span)]):
                yield ('negation', *span, f'!({whole(source, span)})')


def starts_of_statements(source):
    for match in re.finditer(r'^[ \t]*(?=[A-Za-z_*+-])', source.masked, re.M):
        if re.search(r'[;{})]\s*$|\belse\s*$', source.masked[:match.end()][-400:].rstrip(' \t')):
            yield match.end()
    for match in re.finditer(r'\) (?=[a-z_][^;{}\n]*;)', source.masked):
        yield match.end()  # behind an if's condition, on its line


def statements(source):
    for begin in starts_of_statements(source):
        end = source.statement_end(begin)
        if end is None:
            continue
        text, code = source.text[begin:end], source.masked[begin:end]
        if code.startswith('return '):
            yield from returned(source, begin, end)
            continue
        is_jump = (re.match(r'continue;|throw |refuse\(|fail\(', code) and
                   source.masked[:begin].rstrip().endswith(')'))
        changes = re.match(r'(?:\+\+|--)?[\w.:>\[\]()*& -]*?(?:\(| [-+*/|&%]?= |\+\+;|--;)', code)
        word = re.match(r'[\w:]+(?:<[^;]*?>)?[&*]? [\w\[]|[\w:]+<.*?>[&*]? ?[\w(]', code)
        if re.match(r'(?:return|if|for|while|switch|using|const|auto|static|else|do|break|case|delete|throw|'
                    r'goto|let|var|typedef|extern|struct|class|namespace|function|async|default|public|'
                    r'private)\b',
                    code):
            changes = None
        if '{' in code and source.language != 'js' and '}' not in code:
            continue
        if (changes and not word) or is_jump:
            yield ('statement left out', begin, end, ';')
        sign = re.match(r'[\w.\[\]>:()-]+ ([-+*/|]=) ', code)
        if sign and sign.group(1) in COMPOUND and not has_text(source, (begin, end)) and changes:
            yield ('arithmetic', begin, end,
                   text[:sign.start(1)] + COMPOUND[sign.group(1)] + text[sign.end(1):])


def returned(source, begin, end):
    first, last = source.stripped(begin + len('return'), end - 1)
    value = source.text[first:last]
    zero = r'(?:\{\}|nullptr|false|true|0|\d+|0\.0f?|"[^"]*"|std::nullopt|null|undefined|ExitCode::Done)$'
    if re.match(zero, value) or has_text(source, (first, last)):
        return
    if source.language == 'js':
        yield ('return of nothing', begin, end, 'return null;')
    elif source.language == 'glsl':
        heads = re.findall(r'^(Float|Int|Bool|Vec[234]) \w+\(', source.masked[:begin], re.M)
        every = re.findall(r'^(\w+) \w+\(', source.masked[:begin], re.M)
        if heads and every[-1] == heads[-1]:
            zero = {'Int': '0', 'Bool': 'false'}.get(heads[-1], '0.0f')
            inner = ', '.join([f'Float({zero})'] * int(heads[-1][3])) if heads[-1][:3] == 'Vec' else zero
            yield ('return of nothing', begin, end, f'return {heads[-1]}({inner});')
    elif not value.startswith(('{', '[')):
        yield ('return of nothing', begin, end, f'return std::decay_t<decltype({value})>{{}};')


def type_of(source, name, before):
    """As the nearest declaration above says, where it is this plain."""
    found = re.findall(rf'\b([A-Za-z_][\w:]*(?:<[\w:, ]+>)?[&*]*) {re.escape(name)}\b(?=\s*[;,)=({{\[])',
                       source.masked[:before])
    found = [kind for kind in found if kind not in ('return', 'else', 'const', 'new', 'case', 'throw')]
    return found[-1].rstrip('&') if found else None


def calls(source):
    for match in re.finditer(r'(?<![\w.>:])((?:[A-Za-z_]\w*(?:::|\.|->))*[A-Za-z_]\w*)\(', source.masked):
        name, i = match.group(1), source.index.get(match.end() - 1)
        if i not in source.partner or name in ('if', 'for', 'while', 'switch', 'return', 'sizeof',
                                               'decltype'):
            continue
        if re.search(r'[\w>&*]\s$', source.masked[:match.start()]) and not re.search(
                r'(?:\breturn|\belse|&&|[-+*/] [*&]?)\s$', source.masked[:match.start()]):
            continue  # a declaration
        spans, end = source.arguments(i), source.tokens[source.partner[i]].end()
        if source.language == 'js' and re.match(r'\s*\{', source.masked[end:]):
            continue  # a method's head, of which no compiler complains: the whole page would not run
        arguments = [whole(source, span) for span in spans]
        head = source.text[match.start():match.end()]
        for low, high in (('min', 'max'), ('max', 'min')):
            for form in ('std::{}', '{}_of', 'Math.{}'):
                if name == form.format(low):
                    yield ('smaller and larger', match.start(), end,
                           form.format(high) + source.text[match.end() - 1:end])
        if name == 'sel' and len(arguments) == 3:
            yield ('choice', match.start(), end, f'sel({arguments[0]}, {arguments[2]}, {arguments[1]})')
        if name in SYMMETRIC:
            continue
        for k in range(len(arguments) - 1):
            a, b = arguments[k:k + 2]
            if not (re.fullmatch(r'[a-z_]\w*', a) and re.fullmatch(r'[a-z_]\w*', b)) or a == b:
                continue
            kind = type_of(source, a, match.start())
            if source.language != 'js' and (kind is None or kind != type_of(source, b, match.start())):
                continue
            changed = arguments[:k] + [b, a] + arguments[k + 2:]
            yield ('arguments swapped', match.start(), end, f'{head}{", ".join(changed)})')


def subscripts(source):
    for match in re.finditer(r'(?<=[\w)\]])\[(?=[\w(])', source.masked):
        i = source.index.get(match.start())
        if i in source.partner:
            span = source.stripped(match.end(), source.tokens[source.partner[i]].start())
            inner = whole(source, span)
            if '"' not in source.masked[slice(*span)] and not re.match(r'[A-Z&=]|k[A-Z]', inner):
                yield ('index', *span, f'{inner} + 1')


def messages(source):
    """A value printed within a sentence comes out otherwise: `altered` changes its first digit, or else its
    letters."""
    if source.language == 'js':
        for match in re.finditer(r'`(?:[^`\\]|\\.)*`', source.text):
            for value in re.finditer(r'\$\{([^{}`]+)\}', match.group()):
                begin = match.start() + value.start(1)
                yield ('message', begin, begin + len(value.group(1)), f'altered({value.group(1)})')
        return
    if source.language != 'cpp':
        return
    for i, token in enumerate(source.tokens):
        if token.group() != '+':
            continue
        before = source.masked[:token.start()].rstrip()
        begin, end = source.stripped(token.end(), source.operand_end(i, PRECEDENCE['+']))
        after = source.masked[end:].lstrip()
        if '"' in source.masked[begin:end][:1] or not (before.endswith('"') or after.startswith('+ "')):
            continue
        if begin < end:
            yield ('message', begin, end, f'altered({source.text[begin:end]})')


def all_places(source):
    for operator in (binary, numbers, conditions, statements, calls, subscripts, messages):
        for kind, begin, end, fault in operator(source):
            line_begin = source.text.rfind('\n', 0, begin) + 1
            line_end = source.text.find('\n', end)
            if source.text[begin:end].count('\n') > 3 or source.is_fixed(begin, end):
                continue
            if '//' in source.text[begin:end] or COST_ONLY.search(source.text[line_begin:line_end]):
                continue
            # In a class or a namespace: the values that members begin with, but no array's size, and no zero,
            # which nearly all replace before anything reads it.
            if source.language == 'cpp' and not source.is_in_function(begin) and (
                    kind != 'constant' or '[' in source.text[line_begin:begin].split('=')[0] or
                    re.fullmatch(r'0(?:\.0)?f?|false', source.text[begin:end])):
                continue
            if kind != 'message' and source.text[begin:end].strip() == fault.strip():
                continue
            yield kind, begin, end, fault
