"""What drawing faults needs to know of a text in C++, in the shaders' common subset or in JavaScript:
where its comments and strings stand, where an operand begins and ends, and what no variable can change at
run time."""
import re

OPEN, CLOSE = '([{', ')]}'
STRINGS = {
    'c': r'//[^\n]*|/\*.*?\*/|R"(?P<raw>\w*)\(.*?\)(?P=raw)"|"(?:[^"\\\n]|\\.)*"|'
         r"(?<!\w)'(?:[^'\\\n]|\\.)+'",
    'js': r'//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"|' r"'(?:[^'\\\n]|\\.)*'|`(?:[^`\\]|\\.)*`|"
          r'(?<=[(,=:&|])\s*/(?![/*\s])(?:[^/\\\n]|\\.)+/[a-z]*',
}
PRECEDENCE = {'||': 4, '??': 4, '&&': 5, '|': 6, '^': 7, '&': 8, '==': 9, '!=': 9, '===': 9, '!==': 9,
              '<=>': 10, '<': 10, '>': 10, '<=': 10, '>=': 10, '<<': 11,
              '>>': 11, '+': 12, '-': 12, '*': 13, '/': 13, '%': 13}
# Binary operators stand between blanks, as the formatter writes them; templates and pointers do not.
TOKEN = re.compile(
    r'[()\[\]{};,]|\?\?|\?(?!\.)|(?<!:):(?!:)|'
    r'(?<=\s)(?:<=>|<<=|>>=|===|!==|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%|&^]=|->|=>|[-+*/%|&^<>=])(?=\s)|'
    r'\b(?:return|throw|else|case|do|new|delete|co_return|typeof|of|in)\b')


def mask(text, language):
    """The text with blanks for comments and with `"____"` for strings, every character in its place."""
    def hide(match):
        part = match.group()
        if part.startswith(('//', '/*')):
            return re.sub(r'[^\n]', ' ', part)
        return re.sub(r'[^\n]', '_', part[:-1]).replace('_', '"', 1) + '"'
    return re.sub(STRINGS['js' if language == 'js' else 'c'], hide, text, flags=re.DOTALL)


class SourceText:
    def __init__(self, path, text):
        self.path, self.text = path, text
        self.language = {'js': 'js', 'glsl': 'glsl'}.get(path.rsplit('.', 1)[1], 'cpp')
        self.masked = mask(text, self.language)
        self.tokens = list(TOKEN.finditer(self.masked))
        self.index = {token.start(): i for i, token in enumerate(self.tokens)}
        self.partner = self.partners()
        self.fixed = self.fixed_spans()

    def partners(self):
        stack, partner = [], {}
        for i, token in enumerate(self.tokens):
            if token.group() in OPEN:
                stack.append(i)
            elif token.group() in CLOSE and stack:
                j = stack.pop()
                partner[i], partner[j] = j, i
        return partner

    def fixed_spans(self):
        """What the compiler evaluates, and what is not code: preprocessor lines, whole conditional parts,
        constants, declarations of shaders."""
        spans = [match.span() for match in re.finditer(r'^[ \t]*#(?:[^\n]*\\\n)*[^\n]*', self.masked, re.M)]
        if self.language == 'glsl':
            names = 'TEXTURE|ATTRIBUTE|VARYING_SMOOTH|VARYING_FLAT|OUTPUT|STACK|CHOICE|TRACE'
            spans += [m.span() for m in re.finditer(rf'\b(?:{names})\([^\n]*', self.masked)]
            return spans
        if self.language == 'cpp':
            spans += [m.span() for m in re.finditer(r'^#if.*?^#endif', self.masked, re.M | re.S)]
            words = r'\b(?:constexpr|consteval|constinit|static_assert|enum|using|template|requires|' \
                    r'noexcept)\b|\boperator(?=[^\w\s])|\bif constexpr\b'
            spans += [(m.start(), self.end_of_declaration(m.end())) for m in re.finditer(words, self.masked)]
        return spans

    def end_of_declaration(self, begin):
        i = next((i for i, token in enumerate(self.tokens) if token.start() >= begin), None)
        while i is not None and i < len(self.tokens):
            sign = self.tokens[i].group()
            if sign == ';':
                return self.tokens[i].end()
            if sign in CLOSE:
                return self.tokens[i].start()
            if sign in OPEN and i in self.partner:
                i = self.partner[i]
                end = self.tokens[i].end()
                if sign == '{' and not re.match(r'\s*[;,)({]', self.masked[end:end + 80]):
                    return end
            i += 1
        return len(self.text)

    def is_fixed(self, begin, end):
        return any(first < end and begin < last for first, last in self.fixed)

    def is_braced_value(self, opening):
        """Does `{` begin a value such as Vec{1, 2} rather than a block?"""
        return bool(re.search(r'[\w>]$', self.masked[:opening][-1:]))

    def operand_begin(self, i, precedence):
        """Of the operand to the left of token i: what binds at least as tightly as `precedence`."""
        at = i - 1
        while at >= 0:
            token = self.tokens[at]
            sign = token.group()
            if sign in CLOSE:
                if at not in self.partner or (sign == '}' and not self.is_braced_value(
                        self.tokens[self.partner[at]].start())):
                    return token.end()
                at = self.partner[at]
            elif PRECEDENCE.get(sign, 0) < precedence:
                return token.end()
            at -= 1
        return 0

    def operand_end(self, i, precedence):
        """Of the operand to the right of token i: what binds more tightly than `precedence`."""
        at = i + 1
        while at < len(self.tokens):
            token = self.tokens[at]
            sign = token.group()
            if sign in OPEN:
                if at not in self.partner or (sign == '{' and not self.is_braced_value(token.start())):
                    return token.start()
                at = self.partner[at]
            elif PRECEDENCE.get(sign, 0) <= precedence:
                return token.start()
            at += 1
        return len(self.text)

    def stripped(self, begin, end):
        """The span without blanks and comments around."""
        part = self.masked[begin:end]
        return begin + len(part) - len(part.lstrip()), begin + len(part.rstrip())

    def operands(self, i):
        """The spans left and right of the operator that token i is."""
        precedence = PRECEDENCE[self.tokens[i].group()]
        return (self.stripped(self.operand_begin(i, precedence), self.tokens[i].start()),
                self.stripped(self.tokens[i].end(), self.operand_end(i, precedence)))

    def arguments(self, i):
        """The spans between the commas of the bracket that token i opens."""
        if i not in self.partner:
            return []
        spans, begin, at = [], self.tokens[i].end(), i + 1
        while at < self.partner[i]:
            sign = self.tokens[at].group()
            if sign in OPEN:
                at = self.partner.get(at, at)
            elif sign == ',':
                spans.append(self.stripped(begin, self.tokens[at].start()))
                begin = self.tokens[at].end()
            at += 1
        return spans + [self.stripped(begin, self.tokens[self.partner[i]].start())]

    def statement_end(self, begin):
        """Behind the semicolon of the statement that begins here."""
        at = next((i for i, token in enumerate(self.tokens) if token.start() >= begin), len(self.tokens))
        while at < len(self.tokens):
            sign = self.tokens[at].group()
            if sign == ';':
                return self.tokens[at].end()
            if sign in OPEN and at in self.partner:
                at = self.partner[at]
            elif sign in CLOSE:
                return None
            at += 1
        return None

    def is_in_function(self, begin):
        """Does an enclosing brace follow a function's head, or a condition's?"""
        at = next((i for i, token in enumerate(self.tokens) if token.start() >= begin), len(self.tokens)) - 1
        while at >= 0:
            sign = self.tokens[at].group()
            if sign in CLOSE and at in self.partner:
                at = self.partner[at]
            elif sign == '{':
                before = self.masked[:self.tokens[at].start()].rstrip()[-200:]
                head = r'(?:\)|\bconst|\boverride|\bnoexcept|\belse|\bdo|\btry|\]|-> [\w:<>, *&]+|=>)$'
                if re.search(head, before) or \
                        re.search(r'\)\s*:[^;{}]*(?:\{[^{}]*\}[^;{}]*)*$', before):
                    return True
            at -= 1
        return False

    def line_of(self, begin):
        return self.text.count('\n', 0, begin) + 1
