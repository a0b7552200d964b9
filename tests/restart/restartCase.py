# SPDX-License-Identifier: GPL-3.0-or-later
#
# Cases that are run in pieces, their fields and the count of checks.

import math
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent/'tools'))
sys.dont_write_bytecode = True

from fieldFile import content, values  # noqa: E402

here = Path(__file__).resolve().parent
runs = here/'run'
templates = {
    'wall': here/'../regression/controls/case',
    'channel': here/'../../tutorials/poiseuille',
    'cavity': here/'../../tutorials/cavity',
    'flap': here/'../../tutorials/perpendicularFlap',
}
restartFields = ['U', 'p', 'D', 'sigma', 'phi', 'Uf', 'Df', 'traction',
                 'continuityError', 'U_0', 'p_0', 'D_0', 'phi_0', 'Uf_0',
                 'Df_0', 'continuityError_0']
tight = '''PIMPLE { residualControl { fluidMomentum 1e-10; solidMomentum 1e-10;
interfaceTraction 1e-10; continuity 1e-10; } }'''
timeout = 300


# * * * * * * * * * * * * * * * counting  * * * * * * * * * * * * * * * * * #

counts = {True: 0, False: 0}


def check(ok, case, what, found=''):
    '''A row of the table'''
    ok = bool(ok)
    counts[ok] += 1
    verdict = 'pass' if ok else 'FAIL'
    print(f'{verdict}  {case:<25}  {what:<47}  {found}'.rstrip(), flush=True)
    return ok


def note(case, what, found=''):
    '''A row that is not judged'''
    print(f"      {case:<25}  {what:<47}  {found}".rstrip(), flush=True)


def close():
    '''Closing line and exit'''
    print(f'{counts[True]} passed, {counts[False]} failed')
    sys.exit(0 if counts[True] and not counts[False] else 1)


# * * * * * * * * * * * * * * * * fields  * * * * * * * * * * * * * * * * * #

def difference(a, b):
    '''Largest difference over the largest value'''
    a, b = values(a), values(b)
    if len(a) != len(b):
        n = max(len(a), len(b))
        # One of them uniform
        a, b = (x*(n//len(x)) if x else [] for x in (a, b))
    if not a or len(a) != len(b):
        return math.inf
    largest = max(map(abs, a))
    worst = max(abs(x - y) for x, y in zip(a, b))
    if math.isnan(worst):
        return math.inf
    return worst/largest if largest else (math.inf if worst else 0)


def fileNames(folder):
    return {x.name[:-3] if x.name.endswith('.gz') else x.name
            for x in Path(folder).iterdir() if x.is_file()}


def differing(a, b):
    '''Files of two time directories that are not bitwise the same'''
    if not (Path(a).is_dir() and Path(b).is_dir()):
        return [str(x) for x in (a, b) if not Path(x).is_dir()]
    names = sorted(fileNames(a) | fileNames(b)) + ['uniform/time']
    if any((Path(x)/'polyMesh').is_dir() for x in (a, b)):
        names.append('polyMesh/points')
    bad = []
    for name in names:
        one, other = (content(Path(x)/name) for x in (a, b))
        if name == 'uniform/time' and one and other:
            # The value is a sum of steps, in a restart from the folder's name
            one, other = (re.sub(rb'\nvalue .*', b'', x) for x in (one, other))
        if one is None or one != other:
            bad.append(name)
    return bad


def largestDifference(a, b, fields=('U', 'p', 'D', 'sigma', 'traction')):
    '''Of some fields, with the name of the worst'''
    try:
        return max((difference(Path(a)/x, Path(b)/x), x) for x in fields)
    except FileNotFoundError as missing:
        return math.inf, str(missing)


# * * * * * * * * * * * * * * * * cases * * * * * * * * * * * * * * * * * * #

class Case:
    def __init__(self, name, template=None, add=None, files=(), parent=runs):
        '''Copy of a template, or of another Case, with the mesh.
        add: text to append, by file. files: folders to lay over the template
        '''
        self.path = Path(parent)/name
        self.name = name
        self.processes = []
        shutil.rmtree(self.path, ignore_errors=True)
        source = template.path if isinstance(template, Case) \
            else templates[template]
        keep = shutil.ignore_patterns(
            'log.*', 'postProcessing', 'VTK', '*.unfinished', 'unfinishedTime',
            '[1-9]*', '0.[0-9]*', '*e-*', *([] if isinstance(template, Case)
            else ['polyMesh', '0', 'parameters.local', 'processor*']))
        shutil.copytree(source, self.path, ignore=keep)
        for folder in files:
            shutil.copytree(folder, self.path, dirs_exist_ok=True)
        if not (self.path/'0').is_dir():
            shutil.copytree(self.path/'0.orig', self.path/'0')
        for file, text in (add or {}).items():
            self.add(file, text)
        if not (self.path/'constant/polyMesh').is_dir():
            self.tool('blockMesh')
            if (self.path/'system/setFieldsDict').is_file():
                self.tool('setFields')

    def add(self, file, text):
        '''Later entries of a dictionary replace earlier ones'''
        with open(self.path/file, 'a') as f:
            f.write(text + '\n')

    def control(self, text):
        self.add('system/controlDict', text)

    def tool(self, *command):
        '''An OpenFOAM tool, which must succeed'''
        log = self.path/('log.' + command[0])
        with open(log, 'w') as out:
            status = subprocess.run(
                command, cwd=self.path, stdin=subprocess.DEVNULL, stdout=out,
                stderr=subprocess.STDOUT, timeout=timeout).returncode
        if status:
            check(False, self.name, ' '.join(command), f'see {log}')
        return status == 0

    def start(self, n=1, options=(), log=None, limit=None):
        '''Start the solver on n processors, without waiting.
        limit: largest size of a file [kB]'''
        command = ['umfsiFoam', *options]
        if n > 1:
            command = ['mpirun', '-np', str(n), *command, '-parallel']
        if limit:
            command = ['bash', '-c', 'trap "" XFSZ; ulimit -f "$0"; exec "$@"',
                       str(limit), *command]
        self.log = log or self.path/'log.umfsiFoam'
        with open(self.log, 'w') as out:
            return subprocess.Popen(
                command, cwd=self.path, stdin=subprocess.DEVNULL, stdout=out,
                stderr=subprocess.STDOUT,
                # Background jobs of a shell ignore it
                preexec_fn=lambda: signal.signal(signal.SIGINT,
                                                 signal.SIG_DFL))

    def wait(self, process):
        try:
            return process.wait(timeout)
        except subprocess.TimeoutExpired:
            for pid in ranks(process.pid) + [process.pid]:
                stop(pid, signal.SIGKILL)
            process.wait()
            return 'timeout'

    def run(self, n=1, what=None, options=(), log=None):
        '''Run to the end. Judged if it does not get there'''
        self.status = self.wait(self.start(n, options, log))
        ended = self.status == 0 and self.ended()
        if not ended or what:
            check(ended, self.name, what or 'the run ends',
                  '' if ended else f'status {self.status}, see {self.log}')
        return ended

    def text(self):
        return self.log.read_text(errors='replace')

    def ended(self):
        text = self.text()
        return re.search('^End$', text, re.M) and 'FOAM FATAL' not in text

    def steps(self):
        '''Times of the steps in the log'''
        return re.findall(r'^Time = (\S+)', self.text(), re.M)

    def processors(self):
        return sorted(self.path.glob('processor[0-9]*')) or [self.path]

    def times(self, folder=None):
        '''Time directories, sorted'''
        folder = folder or self.processors()[0]
        names = [x.name for x in folder.iterdir()
                 if x.is_dir() and re.fullmatch(r'[0-9.e+-]+', x.name)]
        return sorted(names, key=float)

    def last(self):
        return self.times()[-1]

    def setAside(self):
        '''Times that the log says were set aside, in its order'''
        return re.findall(r'^Time (\S+) is not complete', self.text(), re.M)


def same(case, other, what, time=None):
    '''All files of a time bitwise the same, on all processors'''
    time = time or other.last()
    bad = []
    for a, b in zip(case.processors(), other.processors()):
        bad += differing(a/time, b/time)
    if len(case.processors()) != len(other.processors()):
        bad.append('number of processors')
    return check(not bad, case.name, what,
                 f'bitwise at {time} s' if not bad
                 else f'at {time} s differ: ' + ' '.join(bad))


def near(case, other, what, bound, time=None):
    '''Fields of a time the same to a bound'''
    time = time or other.last()
    worst, field = max(
        largestDifference(a/time, b/time)
        for a, b in zip(case.processors(), other.processors()))
    return check(worst <= bound, case.name, what,
                 f'{worst:.1e} ({field}), at most {bound:.0e}')


# * * * * * * * * * * * * * * * processes * * * * * * * * * * * * * * * * * #

def ranks(pid):
    '''Processes that a process has started'''
    found = []
    for stat in Path('/proc').glob('[0-9]*/stat'):
        try:
            name, rest = stat.read_text().rsplit(') ', 1)
        except OSError:
            continue
        if int(rest.split()[1]) == pid and rest[0] != 'Z':
            found.append(int(stat.parent.name))
    return sorted(found)


def stop(pid, how):
    try:
        os.kill(pid, how)
    except ProcessLookupError:
        pass


def waitFor(condition, process, limit=120):
    '''Until the condition holds or the process has ended'''
    end = time.monotonic() + limit
    while time.monotonic() < end and process.poll() is None:
        if condition():
            return True
        time.sleep(0.001)
    return False
