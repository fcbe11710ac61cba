# The add-on's modules that need no Blender: add_on_test.py PACKAGE ZSTRIP [NAME...], the folder zstrip_blender and the
# command. It is read as a package, without its __init__.py, which is Blender's.
import importlib.util
import json
import math
import os
import struct
import sys
import tempfile
import time
import types
import unittest

FOLDER, ZSTRIP = (os.path.abspath(word) for word in sys.argv[1:3])
package = types.ModuleType('zstrip_blender')
package.__path__ = [FOLDER]
sys.modules['zstrip_blender'] = package
command, glb, latest, picture, process = (
    importlib.import_module('zstrip_blender.' + name) for name in ('command', 'glb', 'latest', 'picture', 'process'))


class InFolder(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(lambda: __import__('shutil').rmtree(self.folder))

    def path(self, name):
        return os.path.join(self.folder, name)

    def program(self, name, text):
        path = self.path(name)
        with open(path, 'w', encoding='utf-8') as file:
            file.write('#!/bin/sh\n' + text)
        os.chmod(path, 0o755)
        return path


class Pictures(unittest.TestCase):
    def test_a_colour_picture_has_its_bytes(self):
        found = picture.parse_ppm(b'P6\n# made by hand\n2 1\n255\n' + bytes(range(6)))
        self.assertEqual(found, picture.Picture(2, 1, bytes(range(6))))

    def test_a_grey_picture_has_three_equal_channels(self):
        self.assertEqual(picture.parse_ppm(b'P5 2 1 255 \x07\x09').rgb, b'\x07\x07\x07\x09\x09\x09')

    def test_a_picture_that_ends_too_early_is_an_error_at_every_length(self):
        whole = b'P6 2 2 255\n' + bytes(12)
        picture.parse_ppm(whole)
        for length in range(len(whole)):
            with self.assertRaises(picture.PictureError, msg=length):
                picture.parse_ppm(whole[:length])

    def test_wrong_headers_are_errors(self):
        for header in (b'P3 1 1 255\n', b'P6 0 1 255\n', b'P6 1 4097 255\n', b'P6 -1 1 255\n', b'P6 1 1 65535\n',
                       b'P6 1e9 1 255\n', b'P6 99999999999 1 255\n', b'#', b''):
            with self.assertRaises(picture.PictureError, msg=header):
                picture.parse_ppm(header + bytes(100))

    def test_a_share_of_a_resolution_has_the_pixels_that_blender_renders(self):
        self.assertEqual(picture.rendered_size(100, 200, 29), (29, 58))
        self.assertEqual(picture.rendered_size(1350, 240, 82), (1107, 196))
        for size in range(4, 400):
            for percentage in range(1, 201):
                found = picture.rendered_size(size, size, percentage)[0]
                self.assertTrue(100 * found <= size * percentage < 100 * (found + 1), (size, percentage))

    def test_every_byte_comes_back_from_linear_light(self):
        for byte in range(256):
            single = struct.unpack('f', struct.pack('f', picture.to_linear(byte)))[0]  # as Blender keeps it
            self.assertEqual(picture.to_srgb_byte(single), byte)

    def test_middle_grey_is_a_fifth_of_the_light(self):
        # IEC 61966-2-1: half of the signal is 0.2140 of the light.
        self.assertAlmostEqual(picture.to_linear(127.5), 0.21404, places=5)
        self.assertEqual(picture.hex_colour(0.05, 1.5, -1), '3fff00')

    def test_pixels_are_linear_and_begin_at_the_bottom(self):
        pixels = picture.linear_pixels(picture.Picture(1, 2, bytes([255, 0, 0, 0, 0, 255])))
        self.assertEqual(list(pixels), [0, 0, 1, 1, 1, 0, 0, 1])

    def test_a_panel_on_its_side_is_turned_back(self):
        # The picture abc/def, turned clockwise: da/eb/fc.
        a, b, c, d, e, f = (bytes([code] * 3) for code in b'abcdef')
        panel = picture.Picture(2, 3, d + a + e + b + f + c)
        self.assertEqual(picture.turned_back(panel, 90), picture.Picture(3, 2, a + b + c + d + e + f))
        self.assertEqual(picture.turned_back(panel, 0), panel)


def document(*nodes):
    return {'asset': {'version': '2.0'}, 'nodes': list(nodes), 'scenes': [{'nodes': [0]}], 'scene': 0}


class GlbFiles(unittest.TestCase):
    def test_a_file_comes_back(self):
        for binary in (b'', b'1234', b'12345'):
            made = glb.Glb(document({'name': 'ä'}), binary)
            data = glb.to_bytes(made)
            self.assertEqual(len(data) % 4, 0)
            self.assertEqual(struct.unpack_from('<I', data, 8)[0], len(data))
            found = glb.parse_glb(data)
            self.assertEqual(found.document, made.document)
            self.assertEqual(found.binary.rstrip(b'\0'), binary)

    def test_a_file_that_ends_too_early_is_an_error_at_every_length(self):
        whole = glb.to_bytes(glb.Glb(document({}), b'1234'))
        for length in range(len(whole)):
            with self.assertRaises(glb.GlbError, msg=length):
                glb.parse_glb(whole[:length])

    def test_json_that_is_no_object_is_an_error(self):
        for text in (b'[] ', b'{{ ', b'\xff\xff\xff\xff', b'1   '):
            chunk = struct.pack('<2I', len(text), 0x4E4F534A) + text
            with self.assertRaises(glb.GlbError, msg=text):
                glb.parse_glb(struct.pack('<3I', 0x46546C67, 2, 12 + len(chunk)) + chunk)

    def test_the_camera_is_in_the_object_or_in_its_child(self):
        own = document({'name': 'Lens', 'camera': 0})
        self.assertEqual(glb.camera_of(own, 'Lens'), 'Lens')
        child = document({'name': 'Lens', 'children': [1]}, {'name': 'Lens_Orientation', 'camera': 0})
        self.assertEqual(glb.camera_of(child, 'Lens'), 'Lens_Orientation')

    def test_a_camera_that_was_not_exported_is_an_error(self):
        for broken in (document({'name': 'Lens'}), document({'name': 'Lens', 'children': [7, 'x']}), {}, {'nodes': 3},
                       document(5)):
            with self.assertRaises(glb.GlbError):
                glb.camera_of(broken, 'Lens')

    def test_a_camera_is_added_to_the_scene_that_is_shown(self):
        before = glb.Glb({'nodes': [{}], 'scenes': [{}, {'nodes': [0]}], 'scene': 1}, b'')
        after = glb.with_camera(before, 'view', range(16), glb.Lens(angle=1.0), 2.0).document
        self.assertEqual(after['scenes'][1]['nodes'], [0, 1])
        self.assertEqual(after['nodes'][1], {'name': 'view', 'matrix': list(range(16)), 'camera': 0})
        self.assertEqual(after['cameras'][0]['perspective']['yfov'], 1.0)
        self.assertEqual(before.document['scenes'][1]['nodes'], [0], 'the first one stays as it is')
        parallel = glb.with_camera(before, 'view', range(16), glb.Lens(half_height=3), 2.0).document
        self.assertEqual(parallel['cameras'][0]['orthographic']['xmag'], 6)
        with self.assertRaises(glb.GlbError):
            glb.with_camera(glb.Glb({'scenes': [{}], 'scene': 4}, b''), 'view', range(16), glb.Lens(), 1)

    def test_what_points_up_in_blender_points_up_in_gltf(self):
        # A camera at (1, 2, 3) that looks along Blender's +y, its top along +z.
        matrix = ((1, 0, 0, 1), (0, 0, -1, 2), (0, 1, 0, 3), (0, 0, 0, 1))
        columns = glb.to_y_up(matrix)
        self.assertEqual(columns[12:15], [1, 3, -2])
        self.assertEqual(columns[4:7], [0, 1, 0], 'the top of the camera')
        self.assertEqual(columns[8:11], [0, 0, 1], 'its back')


class Commands(InFolder):
    def test_the_command_is_found_in_path(self):
        path = self.program('zstrip', 'exit 0\n')
        self.assertEqual(command.find_command('', self.folder), path)
        self.assertEqual(command.find_command(path, ''), path)
        self.assertEqual(command.find_command(self.folder, ''), path, 'the folder of the command')

    def test_a_command_that_is_missing_says_what_to_do(self):
        for preferred in ('', self.path('none')):
            with self.assertRaisesRegex(command.CommandError, 'preferences'):
                command.find_command(preferred, self.folder)

    def test_words_are_those_of_the_command_line(self):
        settings = command.Settings(320, 240, camera='-a b', background='102030', board='pico', panel='st7789',
                                    rotation=90, format='rgb666', ram=' 24K ', samples=4, dither=True, edges=True,
                                    highlights=True, plain_materials=True)
        self.assertEqual(command.render_words('z', 'm.glb', 'p.ppm', settings), [
            'z', 'render', 'm.glb', '-o', 'p.ppm', '--image', 'ppm', '--json', '-', '--size', '320x240',
            '--format', 'rgb666', '--camera=-a b', '--background', '102030', '--highlights', '--plain-materials',
            '--samples', '4', '--dither', '--edges', '--ram', '24K', '--panel', 'st7789', '--rotation', '90'])
        plain = command.Settings(8, 8)
        self.assertEqual(command.plan_words('z', 'm.glb', plain), ['z', 'plan', 'm.glb', '--json', '--size', '8x8'])
        bake = command.bake_words('z', 'm.glb', 'folder', 'SKETCH', plain)
        self.assertEqual(bake[:5], ['z', 'bake', 'm.glb', '-o', 'folder/'])
        uf2 = command.bake_words('z', 'm.glb', 'a.uf2', 'UF2', plain, 'pico2', 'player.uf2')
        self.assertEqual(uf2[-4:], ['--board', 'pico2', '--with', 'player.uf2'])

    def test_a_board_with_dma_has_two_strip_buffers(self):
        two = ['--strip-buffers', '2']
        board = command.Settings(8, 8, board='pico')
        self.assertEqual(command.plan_words('z', 'm', board)[-2:], two)
        self.assertEqual(command.bake_words('z', 'm', 'a.hpp', 'HEADER', board)[-2:], two)
        without = command.Settings(8, 8, board='microbit', dma=False)
        self.assertNotIn('2', command.plan_words('z', 'm', without))

    def test_a_picture_lies_on_its_side_where_only_that_fits(self):
        panel = command.Panel('st7789', ((240, 240), (240, 320)), ('rgb565_swapped',))
        turns = [command.rotation_on(panel, *size) for size in ((240, 240), (240, 320), (320, 240), (8, 8))]
        self.assertEqual(turns, [0, 0, 90, 0])
        fixed = command.Panel('sh8601', ((240, 320),), ('rgb565_swapped',), rotates=False)
        self.assertEqual(command.rotation_on(fixed, 320, 240), 0)

    def test_the_last_line_is_the_error_and_warnings_are_none(self):
        err = 'zstrip: reading, 10 s\nzstrip: warning: odd\nzstrip: it failed\nzstrip: warning: odder\n'
        self.assertEqual(command.error_of(process.Outcome(4, '', err)), 'it failed')
        self.assertEqual(command.warnings_of(err), ['odd', 'odder'])
        self.assertIn('status -11', command.error_of(process.Outcome(-11, '', '')))

    def test_reports_that_are_none_are_errors(self):
        for text in ('', '[]', '{}', 'null', '{"boards": 1}', '{"plan": {"bytes": []}, "boards": []}'):
            with self.assertRaisesRegex(command.CommandError, 'as new as the add-on'):
                command.parse_catalogue(text)
            with self.assertRaisesRegex(command.CommandError, 'as new as the add-on'):
                command.parse_plan(text, 'pico')

    def test_figures_that_the_command_does_not_give_are_not_shown(self):
        self.assertEqual(command.Figures().lines('pico'), [])
        lines = command.Figures(needed_ram=5000).lines('microbit')
        self.assertEqual(lines, ['on microbit 5,000 bytes', 'does not fit microbit'])
        self.assertEqual(command.Figures(least_fps=8.2, most_fps=17.3).lines(), ['Predicted 8.2 to 17 fps'])
        self.assertEqual(command.Figures(least_fps=123.4, most_fps=123.4).lines(), ['Predicted 123 fps'])


class Processes(InFolder):
    def test_streams_and_status_are_kept(self):
        outcome = process.run([self.program('p', 'echo out; echo err >&2; exit 5\n')], 60)
        self.assertEqual(outcome, process.Outcome(5, 'out\n', 'err\n'))

    def test_a_program_that_is_missing_ends_with_the_reason(self):
        outcome = process.run([self.path('none')], 60)
        self.assertEqual(outcome.status, 127)
        self.assertIn('none', outcome.err)

    def test_more_output_than_a_pipe_holds_does_not_stop_it(self):
        outcome = process.run([self.program('p', 'head -c 3000000 /dev/zero | tr "\\0" "x" | fold; exit 3\n')], 60)
        self.assertEqual(outcome.status, 3)
        self.assertGreater(len(outcome.out), 3000000)

    def test_bytes_that_are_no_text_are_replaced(self):
        self.assertEqual(process.run([self.program('p', "printf 'a\\377b'\n")], 60).out, 'a\ufffdb')

    def test_progress_is_the_last_line(self):
        go_on = self.path('go')
        running = process.Process([self.program('p', f'echo one >&2; until [ -e {go_on} ]; do sleep 0.01; done\n')])
        told = []

        def tell(line):
            told.append(line)
            if line == 'one':
                open(go_on, 'w').close()

        self.assertEqual(running.wait(tell=tell, interval=0.001).status, 0)
        self.assertIn('one', told)

    def test_cancelling_ends_the_process_and_those_that_it_started(self):
        pid = self.path('pid')
        running = process.Process([self.program('p', f'sleep 1000 & echo $! > {pid}.part; mv {pid}.part {pid}; wait\n')])
        outcome = running.wait(asked_to_stop=lambda: os.path.exists(pid), interval=0.001)
        self.assertTrue(outcome.cancelled)
        with open(pid, encoding='utf-8') as file:
            child = int(file.read())
        while os.path.exists(f'/proc/{child}') and ') Z ' not in open(f'/proc/{child}/stat').read():
            time.sleep(0.001)  # the whole test fails by its time limit

    def test_a_process_that_does_not_listen_is_killed(self):
        self.addCleanup(setattr, process, 'PATIENCE', process.PATIENCE)
        process.PATIENCE = 0.01
        ready = self.path('ready')
        words = [self.program('p', f'trap "" TERM; : > {ready}; while :; do sleep 0.01; done\n')]
        outcome = process.Process(words).wait(asked_to_stop=lambda: os.path.exists(ready), interval=0.001)
        self.assertTrue(outcome.cancelled)

    def test_what_a_process_left_behind_could_not_be_cancelled(self):
        self.addCleanup(setattr, process, 'PATIENCE', process.PATIENCE)
        process.PATIENCE = 0.01
        running = process.Process([self.program('p', '(trap "" TERM; echo >&2 up; while :; do sleep 0.01; done) &\n')])
        ended = lambda: running.progress and running._process.poll() is not None
        self.assertTrue(running.wait(asked_to_stop=ended, interval=0.001).cancelled)

    def test_cancelling_what_has_ended_changes_nothing(self):
        running = process.Process([self.program('p', 'exit 4\n')])
        running.wait()
        running.cancel()
        self.assertEqual(running.outcome().status, 4)


class Made:
    """A process that ends when it is told to."""

    def __init__(self, request):
        self.request, self.running, self.cancelled = request, True, False

    def cancel(self):
        self.cancelled = True

    def outcome(self):
        return process.Outcome(None if self.cancelled else 0, '', '')


class LatestRequests(unittest.TestCase):
    def setUp(self):
        self.now, self.made, self.finished = 0.0, [], []
        self.latest = latest.Latest(self.start, lambda request, outcome: self.finished.append(request), lambda: self.now)

    def start(self, request):
        self.made.append(Made(request))
        return self.made[-1]

    def test_only_the_newest_of_those_that_wait_is_drawn(self):
        for request in 'abc':
            self.latest.ask(request)
        self.latest.step()
        self.latest.ask('d')
        self.latest.ask('e')
        self.latest.step()
        self.assertEqual([made.request for made in self.made], ['c'], 'one at a time')
        self.made[0].running = False
        self.latest.step()
        self.assertEqual(([made.request for made in self.made], self.finished), (['c', 'e'], ['c']))

    def test_a_short_process_is_finished_and_a_long_one_cancelled(self):
        self.latest.ask('a')
        self.latest.step()
        self.latest.ask('b')
        self.now = latest.FINISH_SECONDS
        self.latest.step()
        self.assertFalse(self.made[0].cancelled)
        self.now += 0.1
        self.latest.step()
        self.assertTrue(self.made[0].cancelled)
        self.made[0].running = False
        self.latest.step()
        self.assertEqual((self.finished, self.made[1].request), ([], 'b'))

    def test_a_long_process_goes_on_while_nothing_else_is_asked_for(self):
        self.latest.ask('a')
        self.latest.step()
        self.now = 1000
        self.latest.step()
        self.assertFalse(self.made[0].cancelled)
        self.assertFalse(self.latest.idle)

    def test_closing_cancels_and_forgets(self):
        self.latest.ask('a')
        self.latest.step()
        self.latest.ask('b')
        self.latest.close()
        self.assertTrue(self.made[0].cancelled)
        self.made[0].running = False
        self.latest.step()
        self.latest.ask('c')
        self.latest.step()
        self.assertEqual((len(self.made), self.finished, self.latest.idle), (1, [], True))

    def test_a_request_that_cannot_start_does_not_stop_the_next(self):
        def fail_once(request):
            if request == 'bad':
                raise command.CommandError('no')
            return self.start(request)

        self.latest = latest.Latest(fail_once, lambda request, outcome: None, lambda: self.now)
        self.latest.ask('bad')
        with self.assertRaises(command.CommandError):
            self.latest.step()
        self.assertTrue(self.latest.idle)
        self.latest.ask('good')
        self.latest.step()
        self.assertEqual(self.made[0].request, 'good')


class WithTheCommand(InFolder):
    def run_command(self, words):
        return process.run(words, 120)

    def model(self):
        """A square that faces +z, in a .glb with a camera before it."""
        positions = struct.pack('<12f', -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0)
        indices = struct.pack('<6H', 0, 1, 2, 0, 2, 3)
        accessors = [{'bufferView': 0, 'componentType': 5126, 'count': 4, 'type': 'VEC3', 'min': [-1, -1, 0],
                      'max': [1, 1, 0]}, {'bufferView': 1, 'componentType': 5123, 'count': 6, 'type': 'SCALAR'}]
        views = [{'buffer': 0, 'byteLength': 48}, {'buffer': 0, 'byteOffset': 48, 'byteLength': 12}]
        square = {'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0]}], 'nodes': [{'mesh': 0}],
                  'meshes': [{'primitives': [{'attributes': {'POSITION': 0}, 'indices': 1}]}], 'accessors': accessors,
                  'bufferViews': views, 'buffers': [{'byteLength': 60}]}
        made = glb.with_camera(glb.Glb(square, positions + indices), '-view', glb.to_y_up(
            ((1, 0, 0, 0), (0, 0, -1, -4), (0, 1, 0, 0), (0, 0, 0, 1))), glb.Lens(angle=math.radians(40)), 1)
        with open(self.path('m.glb'), 'wb') as file:
            file.write(glb.to_bytes(made))
        return self.path('m.glb')

    def test_the_catalogue_lists_the_boards_of_plan(self):
        found = command.parse_catalogue(command.checked(self.run_command([ZSTRIP, 'boards', '--json'])))
        settings = command.Settings(64, 64, board='pico')
        plan = command.checked(self.run_command(command.plan_words(ZSTRIP, self.model(), settings)))
        self.assertEqual([board.name for board in found.boards], [entry['board'] for entry in json.loads(plan)['boards']])
        self.assertEqual(found.board('microbit').ram_bytes, 16 * 1024)
        self.assertFalse(found.board('microbit').dma)
        self.assertIn((240, 240), found.panel('st7789').sizes)
        self.assertIn('pico2', found.uf2_boards)
        self.assertIn(found.panel('ssd1306').formats[0], found.formats)
        self.assertIsNone(found.board('none'))

    def test_figures_are_those_of_the_report(self):
        settings = command.Settings(64, 64, board='pico')
        text = command.checked(self.run_command(command.plan_words(ZSTRIP, self.model(), settings)))
        found, report = command.parse_plan(text, 'pico'), json.loads(text)
        board = next(entry for entry in report['boards'] if entry['board'] == 'pico')
        self.assertEqual((found.needed_ram, found.most_fps), (board['needed_ram'], board['frames_a_second']['most']))
        self.assertEqual((found.flash_bytes, found.triangles), (report['flash_bytes'], 2))
        self.assertEqual(report['strip_buffers'], 2)

    def test_every_setting_renders_a_picture_of_its_size(self):
        catalogue = command.parse_catalogue(command.checked(self.run_command([ZSTRIP, 'boards', '--json'])))
        model, output = self.model(), self.path('p.ppm')
        some = [command.Settings(40, 30), command.Settings(40, 30, camera='-view', background='204060', dither=True),
                command.Settings(40, 30, samples=4, highlights=True, plain_materials=True, ram='30K'),
                command.Settings(40, 30, edges=True)]
        some += [command.Settings(40, 30, format=name) for name in catalogue.formats]
        for panel in catalogue.panels:
            on_side = [size[::-1] for size in panel.sizes[:1]] if panel.rotates else []
            for width, height in {*panel.sizes[:1], *on_side}:
                some.append(command.Settings(width, height, panel=panel.name, format=panel.formats[0],
                                             rotation=command.rotation_on(panel, width, height)))
        for settings in some:
            command.checked(self.run_command(command.render_words(ZSTRIP, model, output, settings)))
            with open(output, 'rb') as file:
                found = picture.turned_back(picture.parse_ppm(file.read()), settings.rotation)
            self.assertEqual((found.width, found.height), (settings.width, settings.height), settings)

    def test_a_camera_that_is_added_sees_the_square(self):
        settings = command.Settings(64, 64, camera='-view', background='000000')
        output = self.path('p.ppm')
        command.checked(self.run_command(command.render_words(ZSTRIP, self.model(), output, settings)))
        with open(output, 'rb') as file:
            found = picture.parse_ppm(file.read())
        lit = [index for index in range(64 * 64) if any(found.rgb[3 * index:3 * index + 3])]
        # Half a side, 1, at a distance of 4; 32 pixels are an angle of 20 degrees.
        side = 32 / (4 * math.tan(math.radians(20)))
        self.assertEqual((min(lit) // 64, max(lit) // 64), (round(32 - side), round(32 + side) - 1))

    def test_files_for_firmware_are_written(self):
        model = self.model()
        for kind, name in (('HEADER', 'a.hpp'), ('BLOB', 'a.zsc'), ('SKETCH', 'sketch'), ('UF2', 'a.uf2')):
            settings = command.Settings(240, 240, format='rgb565_swapped', board='pico')
            board = 'pico' if kind == 'UF2' else ''
            out = command.checked(
                self.run_command(command.bake_words(ZSTRIP, model, self.path(name), kind, settings, board)))
            self.assertGreater(json.loads(out)['flash_bytes']['total'], 0)
        self.assertTrue(os.path.exists(self.path('sketch/sketch.ino')))
        for name in ('a.hpp', 'a.zsc', 'a.uf2'):
            self.assertTrue(os.path.exists(self.path(name)), name)

    def test_an_error_is_one_line_without_the_program_before_it(self):
        settings = command.Settings(64, 64, ram='1')
        with self.assertRaisesRegex(command.CommandError, '^RAM of 1 byte is too little.*smallest that works$'):
            command.checked(self.run_command(command.render_words(ZSTRIP, self.model(), self.path('p.ppm'), settings)))


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
