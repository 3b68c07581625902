// Driven by clients/cpp/tests/test_client.py: each word of the command line is one thing to do; images and layers go to standard output.
#include <iostream>

#include "msisf.hpp"

namespace {

template <typename T>
void write(const std::vector<T>& values) {
    std::cout.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(T)));
}

msisf::State state_of(const char* const* words, int count) {
    double numbers[14];
    for (int k = 0; k < count; k++) numbers[k] = std::stod(words[k]);
    msisf::State state{numbers[0], {numbers[1], numbers[2], numbers[3]}, {numbers[4], numbers[5], numbers[6], numbers[7]}};
    if (count == 14) state.motion = {numbers[8], numbers[9], numbers[10], numbers[11], numbers[12], numbers[13]};
    return state;
}

}  // namespace

/// client ADDRESS TOKEN SECONDS COMMAND FRAME [ARGUMENTS]: image, layer NAME, get, rig CAMERAS, or stream; the last two with 8 or 14
/// numbers a state.
int main(int count, char** words) {
    try {
        const msisf::Server server(words[1], words[2], std::stod(words[3]));
        const std::string command = words[4], frame = words[5];
        if (command == "image") {
            write(server.render(frame).data);
        } else if (command == "layer") {
            const msisf::Layer layer = server.layer(frame, words[6]);
            std::cerr << layer.width << ' ' << layer.height << ' ' << layer.planes << '\n';
            write(layer.values);
        } else if (command == "get") {
            std::cout << server.get(frame);
        } else if (command == "rig") {
            msisf::Stream stream(server, frame, words[6]);
            for (const msisf::Image& image : stream.render_all(state_of(words + 7, count - 7))) write(image.data);
            std::cerr << stream.width(1) << ' ' << stream.height(1) << '\n';
        } else {
            const int size = command == "stream" ? 8 : 14;
            msisf::Stream stream(server, frame);
            for (int first = 6; first < count;) {
                try {
                    const bool is_json = words[first][0] == '{';
                    const msisf::Image image = is_json ? stream.render(std::string(words[first])) : stream.render(state_of(words + first, size));
                    first += is_json ? 1 : size;
                    std::cerr << image.number << ' ' << image.width << ' ' << image.height << ' ' << image.bits << '\n';
                    write(image.data);
                } catch (const msisf::Error& error) {
                    if (error.status == 0) throw;
                    std::cerr << "refused: " << error.what() << '\n';
                    first += words[first][0] == '{' ? 1 : size;
                }
            }
        }
    } catch (const msisf::Error& error) {
        std::cerr << "error " << error.status << ": " << error.what() << '\n';
        return 2;
    }
}
