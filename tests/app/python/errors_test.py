"""Exceptions say what the command line says."""

import unittest

import hexoderm
from program import InFolder, run


class Errors(InFolder):
    def setUp(self):
        super().setUp()
        self.session = self.folder / "s.session.json"
        self.calibration = self.folder / "s.calibration.json"
        self.hexo = self.folder / "s.hexo"
        session = hexoderm.simulate(poses=3)
        session.write(self.session)
        session.write(self.hexo)
        hexoderm.solve(session).write(self.calibration)

    def file(self, name, content):
        path = self.folder / name
        path.write_bytes(content)
        return path

    def expect_same(self, kind, call, *arguments):
        _, _, error = run(*arguments)
        said = error.splitlines()[-1]
        self.assertTrue(said.startswith("hexoderm-cli: "), error)
        with self.assertRaises(kind) as raised:
            call()
        self.assertEqual(str(raised.exception), said.removeprefix("hexoderm-cli: "))
        self.assertIs(type(raised.exception), kind)

    def test_files(self):
        text = self.session.read_bytes()
        for kind, path in [
            (hexoderm.StorageError, self.folder / "none.json"),
            (hexoderm.StorageError, self.folder),
            (hexoderm.FormatError, self.file("empty", b"")),
            (hexoderm.FormatError, self.file("half.session.json", text[:500])),
            (hexoderm.FormatError, self.file("picture", b"\x89PNG")),
            (hexoderm.FormatError, self.file("other.json", b'{"format": "other"}')),
            (hexoderm.FormatError, self.file("version.json", text.replace(b'"version": 1', b'"version": 99'))),
            (hexoderm.FormatError, self.file("broken.hexo", self.hexo.read_bytes()[:3000])),
            (hexoderm.FormatError, self.calibration),
        ]:
            with self.subTest(path=path.name):
                self.expect_same(kind, lambda: hexoderm.read_session(path), "solve", path)
        for path in (self.session, self.hexo):
            self.expect_same(hexoderm.FormatError, lambda: hexoderm.read_calibration(path), "evaluate", path)

    def test_what_is_read_is_not_replaced_by_what_is_made_of_it(self):
        robot = self.file("robot.urdf", b'<robot name="arm"><link name="base_link"/></robot>')
        with self.assertRaisesRegex(hexoderm.InvalidArgument, "is one of the inputs"):
            hexoderm.solve(hexoderm.read_session(self.session)).export("robot-urdf", robot, robot=robot)
        recording = self.folder / "s.skinrec"
        with hexoderm.Capture("sim:x17?speed=30", poses=1, auto=True, record=recording) as capture:
            list(capture)
        before = recording.read_bytes()
        with self.assertRaisesRegex(hexoderm.InvalidArgument, "is one of the inputs"):
            hexoderm.Capture(f"replay:{recording}", record=recording)
        self.assertEqual(recording.read_bytes(), before)

    def test_options_of_a_solution(self):
        session = hexoderm.read_session(self.session)
        for name, value in [("solver", "best"), ("centre", "maybe"), ("support_axes", "1"), ("weights", "none"),
                            ("gap_model", "rubber")]:
            with self.subTest(name=name):
                self.expect_same(hexoderm.InvalidArgument, lambda: hexoderm.solve(session, **{name: value}),
                                 "solve", self.session, "--" + name.replace("_", "-"), value)
        for value in (-1.0, 0.0, 1e9, float("nan")):
            with self.assertRaisesRegex(hexoderm.InvalidArgument, "class threshold must be above 0 and at most 1000"):
                hexoderm.solve(session, class_threshold=value)

    def test_simulations(self):
        out = self.folder / "new.session.json"
        for given in [dict(patch="cube"), dict(patch="sheet:0x3"), dict(surface="cylinder:r=0"), dict(surface="moon"),
                      dict(patch="ring9", surface="sphere:r=0.001")]:
            with self.subTest(given=given):
                arguments = [each for name, value in given.items() for each in ("--" + name, value)]
                self.expect_same(hexoderm.InvalidArgument, lambda: hexoderm.simulate(**given),
                                 "simulate", *arguments, "-o", out)
        self.expect_same(hexoderm.StorageError, lambda: hexoderm.simulate(cell_model="square"),
                         "simulate", "--cell-model", "square", "-o", out)
        with self.assertRaisesRegex(hexoderm.StorageError, "square: there is no such file, .*built in: hex-bma150"):
            hexoderm.simulate(cell_model="square")
        # The same words but for what the option is called.
        _, _, error = run("simulate", "--fault", "dead", "-o", out)
        with self.assertRaises(hexoderm.InvalidArgument) as raised:
            hexoderm.simulate(faults=["dead"])
        self.assertEqual(str(raised.exception), error.strip().replace("hexoderm-cli: --fault:", "faults:"))

    def test_exports(self):
        calibration = hexoderm.read_calibration(self.calibration)
        out = self.folder / "x"
        for to, given in [("pdf", {}), ("urdf", dict(model_name="")), ("urdf", dict(patch=99)),
                          ("urdf", dict(in_link="arm"))]:
            with self.subTest(to=to, given=given):
                arguments = [each for name, value in given.items() for each in ("--" + name.replace("_", "-"), value)]
                self.expect_same(hexoderm.InvalidArgument, lambda: calibration.export(to, out, **given),
                                 "export", self.calibration, "--to", to, "-o", out, *arguments)
        # What is lacking is an argument here and an option there.
        with self.assertRaisesRegex(hexoderm.InvalidArgument, "^robot: expected the URDF of the robot that gets the"):
            calibration.export("robot-urdf", out)
        _, _, error = run("export", self.calibration, "--to", "robot-urdf", "-o", out)
        self.assertIn("expected --robot FILE too, the URDF of the robot that gets the skin", error)
        self.expect_same(hexoderm.StorageError, lambda: calibration.export("urdf", self.folder / "no/x"),
                         "export", self.calibration, "--to", "urdf", "-o", self.folder / "no/x")

    def test_captures(self):
        def capture(source, **options):
            with hexoderm.Capture(source, **options) as poses:
                list(poses)

        new = self.folder / "new.hexo"
        for source in ("teapot:1", "sim:cube", "tcp://localhost", "udp://:0"):
            self.expect_same(hexoderm.InvalidArgument, lambda: capture(source),
                             "capture", "--source", source, "-o", new)
        self.expect_same(hexoderm.StorageError, lambda: capture("replay:/none"),
                         "capture", "--source", "replay:/none", "-o", new)
        with self.assertRaisesRegex(hexoderm.StorageError, "s.hexo: exists already"):  # the command line names -o
            capture("sim:x17", output=self.hexo)
        self.expect_same(hexoderm.FormatError, lambda: capture(f"replay:{self.session}"),
                         "capture", "--source", f"replay:{self.session}", "-o", new)

    def test_what_is_no_text_is_said_all_the_same(self):
        with self.assertRaises(hexoderm.StorageError) as raised:
            hexoderm.read(b"/no\xff/\xe4".decode("utf-8", "surrogateescape"))
        self.assertIn("No such file", str(raised.exception))

    def test_they_are_those_of_python_too(self):
        self.assertTrue(issubclass(hexoderm.InvalidArgument, ValueError))
        self.assertTrue(issubclass(hexoderm.FormatError, ValueError))
        self.assertTrue(issubclass(hexoderm.StorageError, OSError))
        self.assertTrue(issubclass(hexoderm.DeviceError, OSError))
