"""The replay page in a browser: bodies are drawn and move, on phone and desktop, light and dark, without errors."""

import time
import unittest

from browser import SHOTS, Browser, folder_and_browser
from program import *

def player(trick):
    return f"exec:/usr/bin/python3 {SOURCE / 'tests/app/motion/motion_engine.py'} {trick}"


READING = "due to ReadPixels"  # the driver complains, late, about this test's own reading of pixels
COLOURS = """(() => { replay.seek(replay.time);  // draws, in the same task as the reading
  const gl = replay.canvas.getContext('webgl2') || replay.canvas.getContext('webgl'), seen = new Set();
  const w = gl.drawingBufferWidth, h = gl.drawingBufferHeight, all = new Uint8Array(4 * w * h);
  gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, all);
  for (let k = 0; k < all.length; k += 4) seen.add(all[k] << 16 | all[k + 1] << 8 | all[k + 2]);
  return seen.size; })()"""


def key(name):
    return f"dispatchEvent(new KeyboardEvent('keydown', {{key: {name!r}}})); replay.time"


class Replay(Test):
    @classmethod
    def setUpClass(cls):
        cls.runs, cls.browser = folder_and_browser(cls, webgl=True)
        falling = body(ball(0.5), (0, 0, 1.75))
        wedge = hull([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
        table = {"type": "compound", "parts": [{"X_BP": {"p": [0, 0, 0], "q": NO_TURN}, "shape": box(2, 2, 1)},
                                               {"X_BP": {"p": [1, 1, 1], "q": NO_TURN}, "shape": wedge}]}
        one = {**scene(falling, body(table, (0, 0, -1), mass={"type": "fixed"})), "gravity": [0, 0, -10],
               "name": "a </script> & {{data}} ball"}
        (cls.runs / "scene.json").write_text(json.dumps(one))
        subprocess.run([PROGRAM, "simulate", "scene.json", "--engine", player("right"), "--until", "3", "--replay", "R.html"],
                       cwd=cls.runs, check=True, capture_output=True)
        cls.page = (cls.runs / "R.html").as_uri()

    def height(self):
        return self.browser.value("replay.pose(0, replay.time).p[2]")

    def test_phone_and_desk_in_light_and_dark(self):
        for width, dark in ((390, True), (1300, False)):
            with self.subTest(width=width, dark=dark):
                self.browser.open(self.page, width, 800, dark=dark)
                self.assertEqual([c for c in self.browser.complaints() if READING not in c], [])
                self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), width)
                self.assertGreater(self.browser.value("replay.canvas.clientHeight"), 400)
                self.assertGreater(self.browser.value(COLOURS), 20)  # the background alone has one colour
                bottom = self.browser.value("document.querySelector('footer').getBoundingClientRect().bottom")
                self.assertLessEqual(bottom, 800.5)
                if SHOTS:
                    self.browser.screenshot(f"{SHOTS}/replay{width}{'dark' if dark else ''}.png", height=800)

    def test_engines_side_by_side(self):
        done = subprocess.run([PROGRAM, "simulate", "scene.json", "--engine", player("right"), "--until", "3", "--replay", "B.html",
                               "--beside", player("higher"), "--beside", player("gives_up")],
                              cwd=self.runs, capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("gives_up gave up at 1 s of 3 s", done.stderr)
        cells = "[...document.querySelectorAll('#cells div')].map(e => [...e.children].map(c => c.textContent))"
        for width, dark in ((1400, True), (400, False)):
            self.browser.open((self.runs / "B.html").as_uri(), width, 600, dark=dark)
            self.assertEqual([c for c in self.browser.complaints() if READING not in c], [])
            self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), width)
            self.browser.value("replay.seek(0.9)")
            self.assertEqual(self.browser.value(cells), [["higher", "0.25 m off"], ["right", ""], ["gives_up", "0 m off"]])
            self.browser.value("replay.seek(3)")
            self.assertEqual(self.browser.value(cells)[2], ["gives_up", "ended at 1 s"])
            if SHOTS:
                self.browser.screenshot(f"{SHOTS}/beside{width}.png", height=600)
        self.camera_and_labels()

    def camera_and_labels(self):
        drawn = lambda: self.browser.value("replay.seek(0.5), replay.canvas.toDataURL()")
        before = drawn()
        turn = "dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowRight', shiftKey: true})); replay.time"
        self.assertEqual(self.browser.value(turn), 0.5)
        turned = drawn()
        self.assertNotEqual(turned, before)
        self.browser.value(key("+"))
        nearer = drawn()
        self.assertNotEqual(nearer, turned)
        for box in ("labels", "follow"):
            self.browser.value(f"document.getElementById('{box}').click()")
            changed = drawn()
            self.assertNotEqual(changed, nearer, box)
            nearer = changed

    def test_scrubbing_moves_a_body(self):
        self.browser.open(self.page, 600, 500)
        self.assertEqual((self.browser.value("replay.time"), self.height()), (0, 1.75))
        before = self.browser.value("replay.seek(0), replay.canvas.toDataURL()")
        self.browser.value("(s => { s.value = 500 / 3; s.dispatchEvent(new Event('input')); })(document.getElementById('scrub'))")
        self.assertTrue(near(self.browser.value("replay.time"), 0.5, 0.01))  # the slider has 1000 steps
        self.assertTrue(near(self.height(), 0.5, 0.05), self.height())
        self.assertNotEqual(self.browser.value("replay.seek(0.5), replay.canvas.toDataURL()"), before)
        self.assertIn("event 1 of 3", self.browser.value("document.getElementById('now').textContent"))

        self.keys_and_play()
        self.impacts_are_marked()
        self.the_name_is_text()

    def keys_and_play(self):
        self.assertEqual(self.browser.value(key("End")), 3)
        self.assertEqual(self.browser.value(key("Home")), 0)
        self.assertGreater(self.browser.value(key("ArrowRight")), 0)
        self.assertTrue(near(self.browser.value(key("n")), 0.5, 1e-9))
        self.assertTrue(near(self.browser.value(key("n")), 1.5, 1e-9))
        self.assertTrue(near(self.browser.value(key("p")), 0.5, 1e-9))
        self.browser.value(key(" "))
        end = time.monotonic() + 60  # a busy machine may draw a frame a second
        while self.browser.value("replay.time") <= 0.6 and time.monotonic() < end:
            time.sleep(0.1)
        self.assertGreater(self.browser.value("replay.time"), 0.6)
        self.browser.value(key(" "))
        stopped = self.browser.value("replay.time")
        time.sleep(0.2)
        self.assertEqual(self.browser.value("replay.time"), stopped)

    def impacts_are_marked(self):
        marked = self.browser.value("""(() => { const c = document.getElementById('marks'), d = c.getContext('2d')
            .getImageData(0, 0, c.width, 1).data; let n = 0;
            for (let x = 0; x < c.width; ++x) if (d[4 * x + 3] && !(x && d[4 * x - 1])) n++; return n; })()""")
        self.assertEqual(marked, 3)

    def the_name_is_text(self):
        self.assertEqual(self.browser.value("document.querySelector('h1').textContent"), "a </script> & {{data}} ball")
        self.assertEqual(self.browser.value("document.title"), "a </script> & {{data}} ball · Touchstone")

    def test_without_webgl_it_says_so(self):
        plain = Browser.open
        self.browser.open("about:blank", 390)
        self.browser.call("Page.addScriptToEvaluateOnNewDocument",
                          source="HTMLCanvasElement.prototype.getContext = (get => function(kind, ...rest) {"
                                 " return kind.startsWith('webgl') || kind.startsWith('experimental') ? null"
                                 " : get.call(this, kind, ...rest); })(HTMLCanvasElement.prototype.getContext)")
        plain(self.browser, self.page, 390)
        self.assertIn("no WebGL", self.browser.value("document.getElementById('view').textContent"))
        self.assertEqual(self.browser.value("replay.seek(3), document.getElementById('now').textContent"), "3.0000 s · event 3 of 3 (impact)")


if __name__ == "__main__":
    unittest.main()
