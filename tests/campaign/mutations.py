"""Changes files a little, so that a reader may stumble: the same ones for the same seed."""

from __future__ import annotations

BYTES = (
    b"",
    b"\x00",
    b"\xff",
    b"\xed\xa0\x80",
    b"\xe2\x80\xae",
    b"\xef\xbb\xbf",
    b"\r",
    b"\n\n",
    b"\\u0000",
    b"\\ud800",
)
SIGNS = b"// O\t S\t M\t { } [ ] ( ) [] {} [[ \" ' , ; | || : * ? # = `` \\".split(b" ")
VALUES = b"null true -1 1e999 NaN Infinity 0.1 =1+1 1:99:99 $x IN WHERE CASE END reduce( range( =~".split()
WORDS = (*BYTES, *SIGNS, *VALUES, b"9" * 400, b"x" * 3000)
MOST_CHANGES = 4
LONGEST = 200_000


def mutated(random, seeds):
    """Return one of ``seeds`` after one to four changes that ``random`` chooses."""
    data = random.choice(seeds)
    for _ in range(random.randint(1, MOST_CHANGES)):
        data = random.choice(CHANGES)(random, data, seeds)[:LONGEST]
    return data


def _span(random, data, most=60):
    begins = random.randint(0, len(data))
    return begins, min(len(data), begins + random.randint(0, most))


def cut(random, data, _):
    begins, ends = _span(random, data)
    return data[:begins] + data[ends:]


def ended(random, data, _):
    return data[: random.randint(0, len(data))]


def doubled(random, data, _):
    begins, ends = _span(random, data, 400)
    return data[:ends] + data[begins:ends] * random.choice((1, 2, 30)) + data[ends:]


def put_in(random, data, _):
    begins, ends = _span(random, data, 4)
    return data[:begins] + random.choice(WORDS) + data[random.choice((begins, ends)) :]


def a_byte(random, data, _):
    place = random.randint(0, len(data))
    return data[:place] + bytes([random.randrange(256)]) + data[place + 1 :]


def lines_changed(random, data, _):
    lines = data.split(b"\n")
    one, other = random.randrange(len(lines)), random.randrange(len(lines))
    lines[one], lines[other] = lines[other], lines[one]
    return b"\n".join(lines)


def spliced(random, data, seeds):
    other = random.choice(seeds)
    return data[: random.randint(0, len(data))] + other[random.randint(0, len(other)) :]


CHANGES = (cut, ended, doubled, put_in, put_in, a_byte, lines_changed, spliced)


def smaller(data, still):
    """Return a shorter text for which ``still`` holds, by taking away parts again and again."""
    size = len(data) // 2
    while size:
        place = 0
        while place < len(data):
            shorter = data[:place] + data[place + size :]
            if still(shorter):
                data = shorter
            else:
                place += size
        size //= 2
    return data
