"""Starting, reaching and ending servers."""

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
