# Finds the command zstrip, builds its command lines, and reads its reports. Without bpy.
import json
import os
import shutil
from dataclasses import dataclass, field

NAME = 'zstrip'
CANCELLED = 'cancelled'  # the error of what the user ended


class CommandError(Exception):
    """What the command complained of, or why it could not be asked, in one line for the user."""


def find_command(preferred='', path=None):
    """Returns the command's path: `preferred`, a file or a name, or else `zstrip` in PATH (or in `path`, folders as in
    PATH). Raises CommandError."""
    wanted = os.path.expanduser(preferred.strip()) or NAME
    if os.path.isdir(wanted):
        wanted = os.path.join(wanted, NAME)
    found = shutil.which(wanted, path=path)
    if found:
        return found
    if preferred.strip():
        raise CommandError(f"'{preferred}' is no program; set the path of zstrip in the add-on's preferences")
    raise CommandError("zstrip is not in PATH; set its path in the add-on's preferences")


@dataclass(frozen=True)
class Board:
    """A board as the command describes it: sizes in bytes, clocks in MHz."""

    name: str
    description: str
    ram_bytes: int
    dma: bool


@dataclass(frozen=True)
class Panel:
    """A controller: sizes of its modules, formats by the option's names, the usual ones first."""

    name: str
    sizes: tuple
    formats: tuple
    rotates: bool = True  # by 90 degrees


@dataclass(frozen=True)
class Catalogue:
    """What `zstrip boards --json` lists."""

    boards: tuple = ()
    uf2_boards: tuple = ()
    panels: tuple = ()
    formats: tuple = ()

    def board(self, name):
        """The Board of this name, or None."""
        return next((board for board in self.boards if board.name == name), None)

    def panel(self, name):
        """The Panel of this name, or None."""
        return next((panel for panel in self.panels if panel.name == name), None)


def rotation_on(panel, width, height):
    """Returns how a picture of this size lies on the Panel: 0 upright, 90 on its side. Sizes that no module has are
    upright: the command then lists those that there are."""
    on_side = (width, height) not in panel.sizes and (height, width) in panel.sizes
    return 90 if panel.rotates and on_side else 0


def parse_catalogue(text):
    """Returns the Catalogue of the command's JSON. Raises CommandError."""
    try:
        report = json.loads(text)
        return Catalogue(
            tuple(Board(str(board['name']), str(board['description']), int(board['ram_bytes']), bool(board['dma']))
                  for board in report['boards']),
            tuple(str(name) for name in report['uf2_boards']),
            tuple(Panel(str(panel['name']), tuple((int(width), int(height)) for width, height in panel['sizes']),
                        tuple(str(name) for name in panel['formats']), bool(panel['rotates']))
                  for panel in report['panels']),
            tuple(str(name) for name in report['formats']))
    except (KeyError, TypeError, ValueError) as error:
        raise CommandError(f'zstrip boards --json: {error!r}; is the command as new as the add-on?') from error


@dataclass(frozen=True)
class Settings:
    """What a picture and its memory are chosen by. Empty words are the command's own defaults."""

    width: int
    height: int
    camera: str = ''            # of a glTF file
    background: str = ''        # RRGGBB
    board: str = ''
    dma: bool = True            # the board's: a strip is sent while the next one is drawn
    panel: str = ''
    rotation: int = 0           # of the picture on the panel: 0, or 90 where the picture lies on its side
    format: str = ''
    ram: str = ''               # as --ram
    samples: int = 1
    dither: bool = False
    edges: bool = False
    highlights: bool = False
    plain_materials: bool = False


def _scene(settings):
    words = ['--size', f'{settings.width}x{settings.height}']
    if settings.format:
        words += ['--format', settings.format]
    # Joined by '=': a name may begin with a dash.
    if settings.camera:
        words.append(f'--camera={settings.camera}')
    if settings.background:
        words += ['--background', settings.background]
    if settings.highlights:
        words.append('--highlights')
    if settings.plain_materials:
        words.append('--plain-materials')
    return words


def _look(settings):
    words = _scene(settings)
    if settings.samples != 1:
        words += ['--samples', str(settings.samples)]
    if settings.dither:
        words.append('--dither')
    if settings.edges:
        words.append('--edges')
    if settings.ram.strip():
        words += ['--ram', settings.ram.strip()]
    return words


def render_words(command, model, picture, settings):
    """Draws one picture of the model as PPM, and its report on standard output. With a panel it is the panel's glass."""
    words = [command, 'render', model, '-o', picture, '--image', 'ppm', '--json', '-']
    words += _look(settings)
    if settings.panel:
        words += ['--panel', settings.panel]
        if settings.rotation:
            words += ['--rotation', str(settings.rotation)]
    return words


def plan_words(command, model, settings):
    """Plans the memory, as JSON on standard output."""
    words = [command, 'plan', model, '--json', *_look(settings)]
    if settings.board and settings.dma:
        words += ['--strip-buffers', '2']
    return words


KINDS = {'HEADER': '.hpp', 'BLOB': '.zsc', 'UF2': '.uf2', 'SKETCH': ''}


def bake_words(command, model, output, kind, settings, uf2_board='', uf2_program=''):
    """Writes a scene for firmware, and its report on standard output. `kind`: a key of KINDS; a sketch is a folder."""
    if kind == 'SKETCH' and not output.endswith('/'):
        output += '/'
    words = [command, 'bake', model, '-o', output, '--json', '-', *_look(settings)]
    if kind == 'UF2':
        if uf2_board:
            words += ['--board', uf2_board]
        if uf2_program:
            words += ['--with', uf2_program]
    elif kind != 'SKETCH' and settings.board and settings.dma:
        words += ['--strip-buffers', '2']
    return words


def fit_words(command, model, output, settings):
    """Makes the model small enough for the board and bakes it; the report on standard output."""
    return [command, 'fit', model, '--board', settings.board, '-o', output, '--json', '-', *_scene(settings)]


_WARNING, _LINE = 'zstrip: warning: ', 'zstrip: '


def warnings_of(err):
    """The warnings on standard error, in order, without their beginning."""
    return [line[len(_WARNING):] for line in err.splitlines() if line.startswith(_WARNING)]


def error_of(outcome):
    """The message of a process.Outcome that failed, in one line."""
    lines = [line.strip() for line in outcome.err.splitlines() if line.strip()]
    errors = [line for line in lines if not line.startswith(_WARNING)]
    if errors:
        return errors[-1][len(_LINE):] if errors[-1].startswith(_LINE) else errors[-1]
    return f'zstrip ended with status {outcome.status} and said nothing'


def checked(outcome):
    """Returns standard output of a process.Outcome that succeeded. Raises CommandError for others."""
    if outcome.status != 0:
        raise CommandError(CANCELLED if outcome.cancelled else error_of(outcome))
    return outcome.out


@dataclass(frozen=True)
class Figures:
    """What `zstrip plan` says of a scene; None where it says nothing. Sizes in bytes."""

    ram_bytes: object = None        # arena and strip buffers
    needed_ram: object = None       # of the board: the same with what a program has beside it
    flash_bytes: object = None
    least_fps: object = None        # of the board
    most_fps: object = None
    triangles: object = None
    left_out: tuple = field(default=())  # effects that the estimate of time does not have

    def lines(self, board=''):
        """The figures in words, a line each."""
        lines = []
        if self.ram_bytes is not None:
            lines.append(f'RAM {self.ram_bytes:,} bytes')
        if self.needed_ram is not None:
            lines.append(f'on {board} {self.needed_ram:,} bytes')
        if self.flash_bytes is not None:
            lines.append(f'Flash {self.flash_bytes:,} bytes')
        if self.most_fps is not None and self.least_fps is not None:
            least, most = f'{self.least_fps:.2g}', f'{self.most_fps:.2g}'
            if self.most_fps >= 99.5:
                least, most = f'{self.least_fps:.0f}', f'{self.most_fps:.0f}'
            rate = most if least == most else f'{least} to {most}'
            lines.append(f'Predicted {rate} fps')
        elif self.needed_ram is not None:
            lines.append(f'does not fit {board}')
        if self.left_out:
            lines.append(f'Predicted without: {", ".join(self.left_out)}')
        return lines


def parse_plan(text, board=''):
    """Returns the Figures of the JSON of `zstrip plan`, for the board if it lists it. Raises CommandError."""
    try:
        report = json.loads(text)
        found = next((entry for entry in report['boards'] if entry['board'] == board), None)
        rate = found['frames_a_second'] if found else None
        return Figures(
            ram_bytes=int(report['plan']['bytes']['total']),
            needed_ram=int(found['needed_ram']) if found else None,
            flash_bytes=int(report['flash_bytes']),
            least_fps=float(rate['least']) if rate else None,
            most_fps=float(rate['most']) if rate else None,
            triangles=int(report['counts']['triangles']),
            left_out=tuple(str(name) for name in report['estimate_leaves_out']))
    except (KeyError, TypeError, ValueError) as error:
        raise CommandError(f'zstrip plan --json: {error!r}; is the command as new as the add-on?') from error
