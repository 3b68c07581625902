"""Starting, reaching and ending servers."""

import os
import signal
import threading

import msisf
import numpy as np
import pytest

STATE = ((1.9e6, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0), 55289.0)
SMALL = msisf.Camera(64, 48, 40.0)


def test_stream_gives_the_images_of_render(moon):
    expected = moon.render(*STATE, camera=SMALL).image
    with moon.stream(camera=SMALL) as stream:
        for _ in range(3):
            np.testing.assert_array_equal(stream.render(*STATE), expected)


def test_stream_goes_on_after_an_error(moon):
    with moon.stream(camera=SMALL) as stream:
        with pytest.raises(msisf.RequestError, match="inside the Moon"):
            stream.render((1.0, 0.0, 0.0), *STATE[1:])
        stream.send(*STATE)
        assert stream.receive().number == 2


def test_wrong_stream_says_what_the_server_says(moon):
    with pytest.raises(msisf.RequestError, match="--samples is 5"):
        moon.stream(samples=5)


def test_threads_have_connections_of_their_own(moon):
    images = {}

    def draw(number):
        images[number] = moon.render((1.9e6, 1e4 * number, 0.0), *STATE[1:], camera=SMALL).image

    threads = [threading.Thread(target=draw, args=(number,)) for number in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()

    for number, image in images.items():
        np.testing.assert_array_equal(image, moon.render((1.9e6, 1e4 * number, 0.0), *STATE[1:], camera=SMALL).image)
    assert len(images) == 4


def test_unix_socket_and_token(tmp_path):
    (tmp_path / "token").write_text("0123456789abcdef\n")
    with msisf.Moon(serve=["--token-file", str(tmp_path / "token")], token="0123456789abcdef") as guarded:
        assert guarded.models()["models"]
        with pytest.raises(msisf.RequestError, match="token") as error:
            msisf.Moon(guarded.address).models()
        assert error.value.status == 401


def test_server_ends_with_the_client():
    moon = msisf.Moon()
    address = moon.address
    assert moon.models()["models"]
    moon.close()
    with pytest.raises(msisf.ServerError, match="no answer"):
        msisf.Moon(address).models()


def test_server_that_does_not_start_says_why():
    with pytest.raises(msisf.ServerError, match="--queue is '0'"):
        msisf.Moon(serve=["--queue", "0"])
    with pytest.raises(msisf.ServerError, match="can't be started"):
        msisf.Moon(program="/no/such/msis")


def test_after_close_the_errors_say_so(moon):
    state = ((1.9e6, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0), 55289.0)
    small = msisf.Camera(8, 8, 40.0)
    for closed in (msisf.Moon(model="LDEM_4"), msisf.Moon(moon.address)):
        frame = closed.render(*state, camera=small)
        stream = closed.stream(camera=small)
        closed.close()
        closed.close()
        for ask in (
            lambda: closed.render(*state), closed.models, closed.metrics, lambda: closed.sun(55289), lambda: closed.stream(camera=small),
            lambda: frame.locate((1, 1)), lambda: stream.render(*state),
        ):  # fmt: skip
            with pytest.raises(msisf.ServerError, match="the Moon is closed: close.. was called"):
                ask()
        with pytest.raises(msisf.ServerError, match="the stream is closed: .*the Moon is closed"):
            stream.render(*state)
    assert moon.render(*state, camera=small).image.shape == (8, 8)


def test_after_the_end_of_the_server_the_errors_say_so():
    state = ((1.9e6, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0), 55289.0)
    small = msisf.Camera(8, 8, 40.0)
    for end, words in ((signal.SIGKILL, "by signal 9"), (signal.SIGTERM, "with exit code 0")):
        with msisf.Moon(model="LDEM_4") as moon:
            frame = moon.render(*state, camera=small)
            with moon.stream(camera=small) as stream:
                os.killpg(moon._process._process.pid, end)
                moon._process._process.wait(60)
                for ask in (lambda: stream.render(*state), moon.models, lambda: moon.render(*state), lambda: frame.locate((1, 1))):
                    with pytest.raises(msisf.ServerError, match=f"the server that msisf.Moon.. started has ended {words}"):
                        ask()
