// An image and the depth of its middle: image http://127.0.0.1:8810 moon.png
#include <fstream>
#include <iostream>

#include "msisf.hpp"

int main(int count, char** words) {
    if (count != 3) {
        std::cerr << "usage: image ADDRESS FILE.png\n";
        return 1;
    }
    try {
        const msisf::Server server(words[1]);
        const std::string frame = R"({"position": [0, 30, 100000], "time": "2024-01-19T12:00:00Z", "width": 512, "height": 512})";
        const std::vector<std::uint8_t> png = server.render(frame, "image/png");
        std::ofstream(words[2], std::ios::binary).write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
        std::cout << "depth of the middle: " << server.layer(frame, "depth").at(256, 256) << " m\n";
    } catch (const msisf::Error& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
}
