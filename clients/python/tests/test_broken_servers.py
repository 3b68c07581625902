"""Servers that hang, die and lie: every failure is an MsisfError, and no answer is taken for that to another request."""

import contextlib
import os
import signal
import sys
import threading

import fakes
import msisf
import numpy as np
import pytest

STEP = 1 if os.environ.get("MSISF_LONG_TESTS") == "1" else 3  # lines from one Ctrl-C to the next
WAIT = 0.4  # s: for what never comes
PATIENT = 60.0  # s: for what comes, on a busy machine too
SMALL = msisf.Camera(64, 48, 40.0)
A = ((1.9e6, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0), 55289.0)
B = ((1.9e6, 2e5, 0.0), (0.0, 0.0, 0.0, 1.0), 55289.0)


@pytest.mark.parametrize("way", ["nothing", "half of the head", "half of the body", "garbage"])
@pytest.mark.parametrize("end", ["hangs", "closes"])
def test_moon_survives_an_exchange_that_did_not_end(way, end):
    def handler(connection, number):
        fakes.read_request(connection)
        if number > 1:
            connection.sendall(fakes.answer(b'{"models": []}'))
            return
        whole = fakes.answer(b'{"models": ["A"]}')
        connection.sendall({"nothing": b"", "half of the head": whole[:30], "half of the body": whole[:-5], "garbage": b"\0\xff\n\n"}[way])
        if end == "hangs":
            fakes.hang(connection)

    with fakes.Fake(handler) as server:
        moon = msisf.Moon(server.address, timeout=WAIT)
        with pytest.raises(msisf.ServerError, match=server.address):
            moon.models()
        moon._http.timeout = PATIENT
        assert moon.models() == {"models": []}


def test_answer_that_nobody_asked_for_is_not_taken_for_the_next_one():
    def handler(connection, number):
        fakes.read_request(connection)
        connection.sendall(fakes.answer(b'{"connection": %d}' % number))
        assert is_read.wait(60.0)
        connection.sendall(fakes.answer(b'"nobody asked for this"'))
        stray_is_sent.set()
        fakes.hang(connection)

    is_read, stray_is_sent = threading.Event(), threading.Event()
    with fakes.Fake(handler) as server:
        moon = msisf.Moon(server.address, timeout=PATIENT)
        assert moon.models() == {"connection": 1}
        is_read.set()
        assert stray_is_sent.wait(60.0)
        assert moon.models() == {"connection": 2}


@pytest.mark.parametrize(
    "content",
    [b"", b"null", b"[]", b"{}", b'{"points": [], "pixels": []}', b'{"points": [{}], "pixels": [7]}', b"\xff",
     b"--\r\nContent-Length: -9\r\n\r\n"],
)
def test_answer_that_makes_no_sense_is_a_server_error(content):
    def handler(connection, _):
        while True:
            fakes.read_request(connection)
            connection.sendall(fakes.answer(content))

    with fakes.Fake(handler) as server:
        moon = msisf.Moon(server.address, timeout=PATIENT)
        view = moon.view(*A)
        for ask in (lambda: moon.render(*A), lambda: view.locate([0, 0]), lambda: view.visible([0, 0])):
            with pytest.raises(msisf.ServerError):
                ask()
        for ask in (moon.stream, moon.models, moon.metrics, lambda: moon.sun(55289)):
            with contextlib.suppress(msisf.MsisfError):
                ask()


LIES = {
    "another number": fakes.image(2, 7),
    "number 0": fakes.image(0, 7),
    "another size": fakes.image(1, 7, width=2, height=4),
    "too few levels": fakes.message(2, fakes.image(1, 7)[4:-1]),
    "no head": fakes.message(2, b"MSIF"),
    "another head": fakes.message(2, b"XXXX" + fakes.image(1, 7)[8:]),
    "text that is not JSON": fakes.message(1, b"{"),
    "text without number": fakes.message(1, b'{"error": "no"}'),
    "error of another state": fakes.message(1, b'{"number": 5, "error": "no"}'),
    "times that are none": fakes.message(1, b'{"number": 1, "wait": null}'),
    "a message without end": b"\x82\x7f" + b"\x7f" * 8,
    "the end": fakes.message(8, b"\x03\xe8bye"),
    "half a message": fakes.image(1, 7)[:9],
    "nothing": b"",
}
NEVER_WHOLE = ("a message without end", "half a message", "nothing")


@pytest.mark.parametrize("lie", LIES)
def test_stream_ends_at_a_lie(lie):
    def handler(connection, _):
        fakes.open_stream(connection)
        fakes.read_message(connection)
        connection.sendall(LIES[lie])
        fakes.hang(connection)

    with fakes.Fake(handler) as server:
        stream = msisf.Moon(server.address, timeout=PATIENT).stream()
        stream._socket._socket.settimeout(WAIT if lie in NEVER_WHOLE else PATIENT)
        with pytest.raises(msisf.ServerError, match=server.address if "the end" not in lie else "bye"):
            stream.render(*A)
        with pytest.raises(msisf.ServerError, match=r"the stream is closed: .* Open another one"):
            stream.render(*B)


def test_stream_of_several_cameras_takes_no_image_for_that_of_another():
    ready = b'{"ready": true, "width": 4, "height": 2, "cameras": [{"width": 4, "height": 2}, {"width": 2, "height": 3}]}'
    good = fakes.image(1, 7) + fakes.image(1, 8, width=2, height=3)
    error = fakes.message(1, b'{"number": 2, "error": "no"}')
    for answers, fails in [
            (good + fakes.image(2, 9) + error + fakes.image(3, 5) + fakes.image(3, 6, width=2, height=3), False),
            (good + fakes.image(2, 9) + fakes.image(3, 9, width=2, height=3), True),
            (good + fakes.image(2, 9) + fakes.image(2, 9), True),
            (good + fakes.image(1, 9), True)]:  # fmt: skip
        def handler(connection, _, answers=answers):
            fakes.open_stream(connection, ready)
            connection.sendall(answers)
            fakes.hang(connection)

        with fakes.Fake(handler) as server:
            stream = msisf.Moon(server.address, timeout=PATIENT).stream(cameras=[SMALL, SMALL])
            assert [image.ravel().tolist() for image in stream.render_all(*A)] == [[7] * 8, [8] * 6]
            with pytest.raises(msisf.MsisfError, match="2 cameras; render_all"):
                stream.render(*A)
            with pytest.raises(msisf.ServerError if fails else msisf.RequestError):
                stream.render_all(*A)
            if not fails:
                assert [int(image[0, 0]) for image in stream.render_all(*A)] == [5, 6]
    with fakes.Fake(lambda connection, _: fakes.open_stream(connection, ready)) as server, pytest.raises(msisf.ServerError):
        msisf.Moon(server.address, timeout=PATIENT).stream(cameras=[SMALL])


@pytest.mark.parametrize("ready", [b"{}", b"[]", b"\xff", b'{"width": "x", "height": 1}', b""])
def test_stream_that_does_not_open_is_a_server_error(ready):
    with fakes.Fake(lambda connection, _: fakes.open_stream(connection, ready)) as server, pytest.raises(msisf.ServerError):
        msisf.Moon(server.address, timeout=PATIENT).stream()


def test_answer_too_many_is_not_taken_for_the_next_image():
    def handler(connection, _):
        fakes.open_stream(connection)
        fakes.read_message(connection)
        connection.sendall(fakes.image(1, 7) + fakes.image(1, 8))
        fakes.hang(connection)

    with fakes.Fake(handler) as server:
        stream = msisf.Moon(server.address, timeout=PATIENT).stream()
        assert stream.render(*A)[0, 0] == 7
        with pytest.raises(msisf.ServerError, match="the answer has number 1, and 2 is due"):
            stream.render(*B)


def interrupt(step, work):
    """Presses Ctrl-C before the so-manieth line of Python; returns whether there are that many."""
    left, happened = [step], [False]

    def trace(frame, event, _):
        if event == "line" and not happened[0] and not frame.f_code.co_filename.startswith(os.path.dirname(__file__)):
            left[0] -= 1
            if left[0] == 0:
                happened[0] = True
                raise KeyboardInterrupt
        return trace

    before = sys.gettrace()
    try:
        sys.settrace(trace)
        work()
    except KeyboardInterrupt:
        pass
    finally:
        sys.settrace(before)
    return happened[0]


def test_ctrl_c_at_any_line_of_a_stream_gives_no_wrong_image():
    with fakes.Fake(fakes.echo_stream) as server:
        moon = msisf.Moon(server.address, timeout=PATIENT)
        step, is_interrupted, refused = 0, True, 0
        while is_interrupted:
            step += STEP
            with moon.stream() as stream:
                is_interrupted = interrupt(step, lambda: stream.render((7, 0, 0), A[1], 0.0))
                try:
                    assert stream.render((9, 0, 0), A[1], 0.0).max() == 9, f"line {step}"
                except msisf.MsisfError:
                    refused += 1
    assert step > 50 and refused > 10 // STEP


def test_ctrl_c_at_any_line_of_a_request_gives_no_wrong_answer():
    with fakes.Fake(fakes.echo_requests) as server:
        moon = msisf.Moon(server.address, timeout=PATIENT)
        step, is_interrupted = 0, True
        while is_interrupted:
            step += STEP
            is_interrupted = interrupt(step, lambda: moon.sun(7.0))
            assert moon.sun(9.0) == {"path": "/v1/sun?mjd=9.0"}, f"line {step}"
    assert step > 100


def test_forked_process_has_connections_of_its_own():
    with fakes.Fake(fakes.echo_requests) as server, fakes.Fake(fakes.echo_stream) as streams:
        moon, stream = msisf.Moon(server.address, timeout=PATIENT), msisf.Moon(streams.address, timeout=PATIENT).stream()
        moon.sun(1.0)
        child = os.fork()
        if child == 0:
            code = 1
            with contextlib.suppress(msisf.ServerError):
                code = 0 if moon.sun(2.0) == {"path": "/v1/sun?mjd=2.0"} and server.address else 2
                stream.render(*A)
                code = 3
            os._exit(code)
        assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
        assert moon.sun(3.0) == {"path": "/v1/sun?mjd=3.0"}
        assert stream.render((9, 0, 0), A[1], 0.0).max() == 9
        assert server.connections == 2


@pytest.fixture(scope="module")
def blocked(moon):
    """A Moon whose way to the real server can be blocked, with the images of A and B."""
    way = fakes.Way(moon.address)
    with fakes.Fake(way) as between:
        yield way, msisf.Moon(between.address, model="LDEM_4", timeout=PATIENT), [moon.render(*state, camera=SMALL).image for state in (A, B)]


def press_ctrl_c(way):
    """As soon as the server has the request."""
    way.on_request = lambda: signal.pthread_kill(threading.main_thread().ident, signal.SIGINT)


def test_real_stream_is_closed_by_ctrl_c_and_by_a_timeout(blocked):
    way, moon, (image_of_a, image_of_b) = blocked
    assert not np.array_equal(image_of_a, image_of_b)
    for stop in (KeyboardInterrupt, msisf.ServerError):
        with moon.stream(camera=SMALL) as stream:
            stream._socket._socket.settimeout(PATIENT if stop is KeyboardInterrupt else WAIT)
            way.is_open.clear()
            if stop is KeyboardInterrupt:
                press_ctrl_c(way)
            with pytest.raises(stop):
                stream.render(*A)
            way.on_request = lambda: None
            way.is_open.set()
            with pytest.raises(msisf.ServerError, match="the stream is closed: .*(KeyboardInterrupt|timed out)"):
                stream.render(*B)
        with moon.stream(camera=SMALL) as stream:
            np.testing.assert_array_equal(stream.render(*B), image_of_b)


def test_real_moon_goes_on_after_ctrl_c_and_after_a_timeout(blocked):
    way, moon, (_, image_of_b) = blocked
    for stop in (KeyboardInterrupt, msisf.ServerError):
        moon._http.timeout = PATIENT if stop is KeyboardInterrupt else WAIT
        moon._http._local = threading.local()  # a new connection, with this timeout
        way.is_open.clear()
        if stop is KeyboardInterrupt:
            press_ctrl_c(way)
        with pytest.raises(stop):
            moon.render(*A, camera=SMALL)
        way.on_request = lambda: None
        way.is_open.set()
        moon._http.timeout = PATIENT
        np.testing.assert_array_equal(moon.render(*B, camera=SMALL).image, image_of_b)


def test_image_of_an_earlier_state_is_not_rendered(moon):
    with moon.stream(camera=SMALL) as stream:
        with pytest.raises(msisf.MsisfError, match="nothing to receive"):
            stream.receive()
        stream.send(*A)
        with pytest.raises(msisf.MsisfError, match="1 images of send.. are not received yet"):
            stream.render(*B)
        assert [image.number for image in stream] == [1]
        np.testing.assert_array_equal(stream.render(*B), moon.render(*B, camera=SMALL).image)


def test_numbers_of_newest_only_are_those_of_the_states(moon):
    with moon.stream(camera=msisf.Camera(256, 256, 40.0), newest_only=True, samples=9) as stream:
        for _ in range(30):
            stream.send(*A)
        numbers = [image.number for image in stream]

    assert numbers[-1] == 30 and len(numbers) < 30
    assert numbers == sorted(set(numbers))
