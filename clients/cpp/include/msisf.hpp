// Images of the Moon from a server (msis serve), for C++17 on POSIX systems. One header, no library; docs/clients.md says how it is used.
// Units: m, rad, days (MJD, UTC); frame MOON_ME. No class here is for several threads at once.
#ifndef MSISF_HPP
#define MSISF_HPP

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace msisf {

/// What went wrong; status is that of HTTP: 400 to 499 the request, 0 the connection.
class Error : public std::runtime_error {
  public:
    Error(const std::string& what, int status_) : std::runtime_error(what), status(status_) {}
    int status;
};

/// Where the camera is, and when.
struct State {
    double mjd;                        ///< days, UTC
    std::array<double, 3> position;    ///< m
    std::array<double, 4> quaternion;  ///< qx, qy, qz, q0: from camera axes (looks along -x, y right, z up) to MOON_ME
    /// Velocity over the Moon (m/s) and angular velocity about the camera's axes (rad/s), for a camera with a shutter.
    std::optional<std::array<double, 6>> motion = std::nullopt;
};

/// Grey levels by rows, from the left and from the top.
struct Image {
    std::uint32_t number = 0;  ///< of the state in its stream
    std::uint32_t width = 0, height = 0;
    int bits = 8;                    ///< 8 or 16 (little-endian)
    std::vector<std::uint8_t> data;  ///< width * height * bits / 8 bytes

    /// The level of a pixel, counted from 0.
    int level(std::uint32_t x, std::uint32_t y) const {
        const std::size_t pixel = std::size_t{y} * width + x;
        return bits == 8 ? data[pixel] : data[2 * pixel] | data[2 * pixel + 1] << 8;
    }
};

/// A layer of ground truth: planes of width * height values, by rows; NaN where it has none.
struct Layer {
    std::uint32_t width = 0, height = 0, planes = 0;
    std::vector<double> values;  ///< pixel by pixel, each with all its planes, as in the files of NumPy

    double at(std::uint32_t x, std::uint32_t y, std::uint32_t plane = 0) const {
        return values[(std::size_t{y} * width + x) * planes + plane];
    }
};

namespace detail {

inline std::string base64(const std::uint8_t* bytes, std::size_t length) {
    static const char* const signs = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t start = 0; start < length; start += 3) {
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < 3; k++) word = word << 8 | (start + k < length ? bytes[start + k] : 0u);
        for (std::size_t k = 0; k < 4; k++) text += start + k <= length ? signs[word >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

/// FIPS 180-4; a WebSocket proves with it that the server has read the request.
inline std::array<std::uint8_t, 20> sha1(std::string text) {
    const auto turned = [](std::uint32_t x, int n) { return x << n | x >> (32 - n); };
    const std::uint64_t bits = 8 * text.size();
    text += '\x80';
    while (text.size() % 64 != 56) text += '\0';
    for (int k = 56; k >= 0; k -= 8) text += static_cast<char>(bits >> k);
    std::uint32_t h[5] = {0x67452301, 0xEFCDAB89, 0x98BADCFE, 0x10325476, 0xC3D2E1F0};
    for (std::size_t block = 0; block < text.size(); block += 64) {
        std::uint32_t w[80];
        for (int k = 0; k < 16; k++) {
            w[k] = 0;
            for (int b = 0; b < 4; b++) w[k] = w[k] << 8 | static_cast<std::uint8_t>(text[block + 4 * k + b]);
        }
        for (int k = 16; k < 80; k++) w[k] = turned(w[k - 3] ^ w[k - 8] ^ w[k - 14] ^ w[k - 16], 1);
        std::uint32_t a = h[0], b = h[1], c = h[2], d = h[3], e = h[4];
        for (int k = 0; k < 80; k++) {
            const std::uint32_t f = k < 20 ? (b & c) | (~b & d) : k < 40 || k >= 60 ? b ^ c ^ d : (b & c) | (b & d) | (c & d);
            const std::uint32_t constant = k < 20 ? 0x5A827999 : k < 40 ? 0x6ED9EBA1 : k < 60 ? 0x8F1BBCDC : 0xCA62C1D6;
            const std::uint32_t next = turned(a, 5) + f + e + constant + w[k];
            e = d, d = c, c = turned(b, 30), b = a, a = next;
        }
        h[0] += a, h[1] += b, h[2] += c, h[3] += d, h[4] += e;
    }
    std::array<std::uint8_t, 20> digest;
    for (int k = 0; k < 20; k++) digest[k] = static_cast<std::uint8_t>(h[k / 4] >> (24 - 8 * (k % 4)));
    return digest;
}

/// The whole number at the begin of a text from the server.
inline std::uint64_t whole(const std::string& text, int base = 10) {
    std::uint64_t number = 0;
    if (std::from_chars(text.data(), text.data() + text.size(), number, base).ec != std::errc{}) {
        throw Error("the server's answer has '" + text.substr(0, 40) + "' where a number is due", 0);
    }
    return number;
}

/// The text of a member of a JSON object; no more JSON than the server's short answers have.
inline std::string json_text(const std::string& json, const std::string& key) {
    std::size_t at = json.find('"' + key + "\":");
    if (at == std::string::npos) return "";
    at = std::min(json.find_first_not_of(' ', at + key.size() + 3), json.size());
    if (json[at] != '"') return json.substr(at, json.find_first_of(",}", at) - at);
    std::string text;
    for (at++; at < json.size() && json[at] != '"'; at++) {
        if (json[at] == '\\' && json[at + 1] == 'u') {
            const std::uint64_t code = whole(json.substr(at + 2, 4), 16);
            text += code < 128 ? static_cast<char>(code) : '?';
            at += 5;
        } else {
            text += json[at] == '\\' ? json[++at] : json[at];
        }
    }
    return text;
}

inline std::string system_error(const std::string& what) { return what + ": " + std::strerror(errno); }

/// A connection to "http://HOST:PORT", or to the path of a Unix socket.
class Connection {
  public:
    Connection(const std::string& address, double seconds) {
        const bool is_web = address.rfind("http://", 0) == 0;
        if (address.rfind("https://", 0) == 0) {
            throw Error("'" + address + "': this client has no TLS. Give the http:// of a proxy beside the program, or a Unix socket", 0);
        }
        if (!is_web && address.find('/') == std::string::npos) {
            throw Error("'" + address + "' is no http://HOST:PORT and no path of a Unix socket, as msis serve prints it", 0);
        }
        is_web ? connect_to_host(address.substr(7)) : connect_to_path(address);
        const int one = 1;
        setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
        const double wait = std::min(1e9, std::max(0.0, seconds));  // 30 years: a time_t holds it everywhere
        const timeval limit{static_cast<time_t>(wait), static_cast<suseconds_t>((wait - static_cast<double>(static_cast<time_t>(wait))) * 1e6)};
        setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
        setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof limit);
    }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;
    ~Connection() { close(socket_); }

    void write(const void* bytes, std::size_t length) {
        for (std::size_t sent = 0; sent < length;) {
            const ssize_t count = send(socket_, static_cast<const char*>(bytes) + sent, length - sent, MSG_NOSIGNAL);
            if (count < 0 && errno != EINTR) throw Error(system_error("the server can't be written to"), 0);
            sent += count < 0 ? 0 : static_cast<std::size_t>(count);
        }
    }

    void read(void* bytes, std::size_t length) {
        char* to = static_cast<char*>(bytes);
        const std::size_t kept = std::min(length, buffer_.size() - used_);
        std::copy_n(buffer_.data() + used_, kept, to);  // an empty vector has no address, which std::memcpy must not get
        used_ += kept;
        for (std::size_t taken = kept; taken < length;) taken += receive(to + taken, length - taken);
    }

    /// The bytes up to an empty line.
    std::string read_head() {
        for (;;) {
            const std::size_t end = buffer_.find("\r\n\r\n", used_);
            if (end != std::string::npos) {
                std::string head = buffer_.substr(used_, end + 2 - used_);
                used_ = end + 4;
                return head;
            }
            if (buffer_.size() > 65536) throw Error("the server's answer is no HTTP", 0);
            char piece[4096];
            buffer_.append(piece, receive(piece, sizeof piece));
        }
    }

    std::string read_line() {
        std::string line;
        for (char sign = 0; line.size() < 2 || line.compare(line.size() - 2, 2, "\r\n") != 0; line += sign) read(&sign, 1);
        return line.substr(0, line.size() - 2);
    }

  private:
    std::size_t receive(char* to, std::size_t length) {
        for (;;) {
            const ssize_t count = recv(socket_, to, length, 0);
            if (count > 0) return static_cast<std::size_t>(count);
            if (count == 0) throw Error("the server closed the connection", 0);
            if (errno != EINTR) throw Error(system_error("no answer of the server"), 0);
        }
    }

    void connect_to_host(const std::string& host_and_port) {
        const std::size_t colon = host_and_port.rfind(':');
        std::string host = host_and_port.substr(0, colon);
        const std::string port = colon == std::string::npos ? "80" : host_and_port.substr(colon + 1);
        if (host.size() > 2 && host.front() == '[') host = host.substr(1, host.size() - 2);
        addrinfo hints{}, *found = nullptr;
        hints.ai_socktype = SOCK_STREAM;
        if (const int code = getaddrinfo(host.c_str(), port.substr(0, port.find('/')).c_str(), &hints, &found); code != 0) {
            throw Error("'" + host_and_port + "' is not found: " + gai_strerror(code), 0);
        }
        for (const addrinfo* one = found; one != nullptr && socket_ < 0; one = one->ai_next) {
            connect_to(one->ai_family, one->ai_addr, one->ai_addrlen);
        }
        freeaddrinfo(found);
        if (socket_ < 0) throw Error(system_error("no server at '" + host_and_port + "'; start one with msis serve"), 0);
    }

    void connect_to_path(const std::string& path) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        if (path.size() >= sizeof address.sun_path) throw Error("the path of the socket is too long: " + path, 0);
        std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
        connect_to(AF_UNIX, reinterpret_cast<const sockaddr*>(&address), sizeof address);
        if (socket_ < 0) throw Error(system_error("no server at '" + path + "'; start one with msis serve --listen"), 0);
    }

    void connect_to(int family, const sockaddr* address, socklen_t length) {
        const int one = socket(family, SOCK_STREAM | SOCK_CLOEXEC, 0);
        if (one >= 0 && connect(one, address, length) == 0) {
            socket_ = one;
        } else if (one >= 0) {
            const int error = errno;
            close(one);
            errno = error;
        }
    }

    int socket_ = -1;
    std::string buffer_;
    std::size_t used_ = 0;
};

/// The head of an answer.
struct Head {
    int status = 0;
    std::map<std::string, std::string> fields;  ///< names in small letters

    explicit Head(const std::string& text) {
        if (text.rfind("HTTP/1.1 ", 0) != 0) throw Error("the server's answer is no HTTP/1.1", 0);
        status = static_cast<int>(whole(text.substr(9, 3)));
        for (std::size_t line = text.find("\r\n") + 2; line < text.size();) {
            const std::size_t end = text.find("\r\n", line), colon = text.find(':', line);
            std::string name = text.substr(line, colon - line);
            std::transform(name.begin(), name.end(), name.begin(), [](unsigned char sign) { return std::tolower(sign); });
            const std::size_t value = std::min(text.find_first_not_of(' ', colon + 1), end);
            fields[name] = text.substr(value, end - value);
            line = end + 2;
        }
    }

    std::string field(const std::string& name) const { return fields.count(name) ? fields.at(name) : ""; }
};

/// Adds bytes to those of a body, piece by piece: a wrong length takes no memory.
inline void read_more(Connection& connection, std::vector<std::uint8_t>& body, std::uint64_t length) {
    while (length > 0) {
        const std::size_t start = body.size(), piece = std::min<std::uint64_t>(length, 1 << 20);
        body.resize(start + piece);
        connection.read(body.data() + start, piece);
        length -= piece;
    }
}

/// The body of an answer, with its length or in chunks.
inline std::vector<std::uint8_t> read_body(Connection& connection, const Head& head) {
    std::vector<std::uint8_t> body;
    if (head.field("transfer-encoding") != "chunked") {
        read_more(connection, body, whole(head.field("content-length")));
        return body;
    }
    for (;;) {
        const std::uint64_t length = whole(connection.read_line(), 16);
        read_more(connection, body, length);
        connection.read_line();
        if (length == 0) return body;
    }
}

[[noreturn]] inline void throw_problem(int status, const std::vector<std::uint8_t>& body) {
    const std::string text(body.begin(), body.end()), detail = json_text(text, "detail");
    throw Error(detail.empty() ? "the server answers " + std::to_string(status) + ": " + text : detail, status);
}

/// A name of this program for the server, which shares itself evenly among the clients by their names.
inline const std::string& client_name() {
    static const std::string name = [] {
        std::random_device random;
        return "cpp-" + std::to_string(random()) + "-" + std::to_string(random());
    }();
    return name;
}

inline std::string request_head(const std::string& method, const std::string& path, const std::string& token) {
    return method + " " + path + " HTTP/1.1\r\nHost: localhost\r\nX-Msisf-Client: " + client_name() + "\r\n" +
        (token.empty() ? "" : "Authorization: Bearer " + token + "\r\n");
}

}  // namespace detail

/// A number as JSON has it, with as many digits as it needs.
inline std::string json(double number) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

/// The members of a frame that say a state, for Server: "fixed-state": [...].
inline std::string json(const State& state) {
    std::string text = "\"fixed-state\": [" + json(state.mjd);
    for (double number : state.position) text += ", " + json(number);
    for (double number : state.quaternion) text += ", " + json(number);
    text += ']';
    if (state.motion) {
        text += ", \"motion\": [";
        for (std::size_t k = 0; k < 6; k++) text += (k ? ", " : "") + json((*state.motion)[k]);
        text += ']';
    }
    return text;
}

/// Single requests, each with a connection of its own. A frame is JSON as docs/server.md has it, e.g. {"position": [0, 30, 1e5], ...}.
class Server {
  public:
    /// address: what msis serve printed; token: that of its --token-file; seconds: the longest wait for a byte.
    explicit Server(std::string address, std::string token = "", double seconds = 120.0)
        : address_(std::move(address)), token_(std::move(token)), seconds_(seconds) {}

    /// The bytes that answer GET.
    std::string get(const std::string& path) const {
        const auto [head, body] = ask(detail::request_head("GET", path, token_) + "Connection: close\r\n\r\n");
        return {body.begin(), body.end()};
    }

    /// The answer to a frame in a form of docs/server.md, e.g. "image/png" or "application/xml".
    std::vector<std::uint8_t> render(const std::string& frame, const std::string& accept) const { return post(frame, accept).second; }

    /// The grey levels of a frame.
    Image render(const std::string& frame) const {
        auto [head, body] = post(frame, "application/octet-stream");
        Image image;
        image.width = number_of(head, "x-msisf-width");
        image.height = number_of(head, "x-msisf-height");
        image.bits = head.field("x-msisf-type") == "u8" ? 8 : 16;
        image.data = std::move(body);
        if (image.data.size() != std::size_t{image.width} * image.height * (image.bits / 8)) {
            throw Error("the image has another length than its head says", 0);
        }
        return image;
    }

    /// A layer of a frame, e.g. "depth"; the frame must not name layers itself.
    Layer layer(const std::string& frame, const std::string& name) const {
        const std::size_t end = frame.rfind('}');
        if (end == std::string::npos) throw Error("the frame is no JSON object: " + frame, 400);
        const auto [head, body] = post(
            frame.substr(0, end) + (frame.find(':') == std::string::npos ? "" : ", ") + "\"layers\": \"" + name + "\"}",
            "application/octet-stream");
        Layer layer{number_of(head, "x-msisf-width"), number_of(head, "x-msisf-height"), number_of(head, "x-msisf-planes"), {}};
        const std::size_t count = std::size_t{layer.width} * layer.height * layer.planes;
        layer.values.resize(count);
        const std::string type = head.field("x-msisf-type");
        if (type == "f64") {
            take<double>(body, layer.values);
        } else if (type == "f32") {
            take<float>(body, layer.values);
        } else if (type == "i32") {
            take<std::int32_t>(body, layer.values);
        } else {
            take<std::uint8_t>(body, layer.values);
        }
        return layer;
    }

    const std::string& address() const { return address_; }
    const std::string& token() const { return token_; }
    double seconds() const { return seconds_; }

  private:
    using Answer = std::pair<detail::Head, std::vector<std::uint8_t>>;

    template <typename T>
    static void take(const std::vector<std::uint8_t>& body, std::vector<double>& values) {
        if (body.size() != values.size() * sizeof(T)) throw Error("the layer has another length than its head says", 0);
        for (std::size_t k = 0; k < values.size(); k++) {
            T value;
            std::memcpy(&value, body.data() + k * sizeof(T), sizeof(T));
            values[k] = static_cast<double>(value);
        }
    }

    static std::uint32_t number_of(const detail::Head& head, const std::string& field) {
        return static_cast<std::uint32_t>(detail::whole(head.field(field)));
    }

    Answer post(const std::string& frame, const std::string& accept) const {
        return ask(
            detail::request_head("POST", "/v1/render", token_) + "Connection: close\r\nContent-Type: application/json\r\nAccept: " + accept
            + "\r\nContent-Length: " + std::to_string(frame.size()) + "\r\n\r\n" + frame);
    }

    Answer ask(const std::string& request) const {
        detail::Connection connection(address_, seconds_);
        connection.write(request.data(), request.size());
        detail::Head head(connection.read_head());
        std::vector<std::uint8_t> body = detail::read_body(connection, head);
        if (head.status != 200) detail::throw_problem(head.status, body);
        return {std::move(head), std::move(body)};
    }

    std::string address_, token_;
    double seconds_;
};

/// A WebSocket in lock-step: a state goes in, its image comes out. A refused state is an Error of status 400, and the stream goes on;
/// after an Error of status 0 it is closed.
class Stream {
  public:
    /// frame: the options of all images, as JSON, without a state.
    /// cameras: several, as a JSON list of what each has of its own, e.g. {"fov": 5, "quaternion": [...], "offset": [...]} (docs/cameras.md);
    /// render_all() has the image of each.
    Stream(const Server& server, const std::string& frame, const std::string& cameras = "")
        : connection_(server.address(), server.seconds()) {
        std::uint8_t nonce[16];
        for (std::uint8_t& byte : nonce) byte = static_cast<std::uint8_t>(random_());
        const std::string key = detail::base64(nonce, sizeof nonce);
        const std::string request = detail::request_head("GET", "/v1/stream", server.token())
            + "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: " + key + "\r\nSec-WebSocket-Version: 13\r\n\r\n";
        connection_.write(request.data(), request.size());
        const detail::Head head(connection_.read_head());
        if (head.status != 101) detail::throw_problem(head.status, detail::read_body(connection_, head));
        const auto digest = detail::sha1(key + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11");
        if (head.field("sec-websocket-accept") != detail::base64(digest.data(), digest.size())) {
            throw Error("the server's answer is not that of a WebSocket", 0);
        }
        const std::string opening = "{\"frame\": " + frame + (cameras.empty() ? "" : ", \"cameras\": " + cameras)
            + ", \"mode\": \"lock-step\", \"format\": \"u8\"}";
        send_message(Text, opening.data(), opening.size());
        std::vector<std::uint8_t> answer;
        receive(answer, LongestText);
        const std::string text(answer.begin(), answer.end());
        if (const std::string error = detail::json_text(text, "error"); !error.empty()) throw Error(error, 400);
        for (std::size_t at = text.find("[{", text.find("\"cameras\"")); at != std::string::npos; at = text.find('{', at + 2)) {
            const std::string camera = text.substr(at);
            sizes_.push_back({size_of(camera, "width"), size_of(camera, "height")});
        }
        if (sizes_.empty()) sizes_.push_back({size_of(text, "width"), size_of(text, "height")});
    }

    std::uint32_t width(std::size_t camera = 0) const { return sizes_.at(camera)[0]; }
    std::uint32_t height(std::size_t camera = 0) const { return sizes_.at(camera)[1]; }

    /// The image of a state; of several cameras that of the first, the others are left out.
    Image render(const State& state) { return render_all(state).front(); }

    /// The images of all cameras at a state, in their order.
    std::vector<Image> render_all(const State& state) {
        double numbers[14] = {state.mjd};
        std::copy(state.position.begin(), state.position.end(), numbers + 1);
        std::copy(state.quaternion.begin(), state.quaternion.end(), numbers + 4);
        if (state.motion) std::copy(state.motion->begin(), state.motion->end(), numbers + 8);
        send_message(Binary, numbers, (state.motion ? 14 : 8) * sizeof(double));
        return next();
    }

    /// The images of changed options, as JSON; they hold for these images only.
    std::vector<Image> render_all(const std::string& changes) {
        send_message(Text, changes.data(), changes.size());
        return next();
    }

    /// The image of changed options, as JSON, e.g. {"position": [0, 30, 1e5], "time": 55289.5}; they hold for this image only.
    Image render(const std::string& changes) { return render_all(changes).front(); }

  private:
    enum Kind { Continued = 0, Text = 1, Binary = 2, Close = 8, Ping = 9, Pong = 10 };
    static constexpr std::size_t LongestText = 1 << 20, HeadLength = 16;

    static std::uint32_t size_of(const std::string& camera, const std::string& name) {
        return static_cast<std::uint32_t>(detail::whole(detail::json_text(camera, name)));
    }

    std::vector<Image> next() {
        if (is_broken_) throw Error("the stream is closed after an error; open another one", 0);
        is_broken_ = true;  // until the answer is here whole: a late one would be taken for that of the next state
        sent_++;
        std::vector<Image> images;
        for (const auto& size : sizes_) images.push_back(next(size));
        is_broken_ = false;
        return images;
    }

    Image next(const std::array<std::uint32_t, 2>& size) {
        const std::size_t pixels = std::size_t{size[0]} * size[1];
        std::vector<std::uint8_t> message;
        const int kind = receive(message, HeadLength + 2 * pixels + LongestText);
        if (kind == Text) {
            is_broken_ = false;
            throw Error(detail::json_text(std::string(message.begin(), message.end()), "error"), 400);
        }
        Image image;
        std::uint32_t head[3];
        const std::size_t length = message.size() - HeadLength;
        if (message.size() < HeadLength || std::memcmp(message.data(), "MSIF", 4) != 0 || (length != pixels && length != 2 * pixels)) {
            throw Error("the server's message is no image of this stream", 0);
        }
        std::memcpy(head, message.data() + 4, sizeof head);  // little-endian, as all machines that run msis
        if (head[1] != size[0] || head[2] != size[1]) throw Error("the image has another size than its camera", 0);
        if (head[0] != sent_) throw Error("the image has number " + std::to_string(head[0]) + ", " + std::to_string(sent_) + " is due", 0);
        image.number = head[0], image.width = head[1], image.height = head[2];
        image.bits = length == pixels ? 8 : 16;
        message.erase(message.begin(), message.begin() + HeadLength);
        image.data = std::move(message);
        return image;
    }

    void send_message(Kind kind, const void* content, std::size_t length) {
        std::vector<std::uint8_t> frame{static_cast<std::uint8_t>(0x80 | kind)};
        const int bytes = length < 126 ? 0 : length < 65536 ? 2 : 8;
        frame.push_back(static_cast<std::uint8_t>(0x80 | (bytes == 0 ? length : bytes == 2 ? 126 : 127)));
        for (int k = bytes - 1; k >= 0; k--) frame.push_back(static_cast<std::uint8_t>(length >> 8 * k));
        std::uint8_t mask[4];
        for (std::uint8_t& byte : mask) byte = static_cast<std::uint8_t>(random_());
        frame.insert(frame.end(), mask, mask + 4);
        for (std::size_t k = 0; k < length; k++) frame.push_back(static_cast<const std::uint8_t*>(content)[k] ^ mask[k % 4]);
        connection_.write(frame.data(), frame.size());
    }

    /// The next message, put together from its fragments.
    int receive(std::vector<std::uint8_t>& message, std::size_t longest) {
        for (int kind = Continued;;) {
            std::uint8_t head[8];
            connection_.read(head, 2);
            const int code = head[0] & 15;
            const bool is_last = head[0] & 0x80;
            std::uint64_t length = head[1] & 0x7F;
            if (length >= 126) {
                const int bytes = length == 126 ? 2 : 8;
                connection_.read(head, static_cast<std::size_t>(bytes));
                length = 0;
                for (int k = 0; k < bytes; k++) length = length << 8 | head[k];
            }
            if (length > longest - std::min(longest, message.size())) throw Error("the server's message is too long", 0);
            if (code >= Close) {
                std::vector<std::uint8_t> content(length);
                connection_.read(content.data(), content.size());
                if (code == Ping) send_message(Pong, content.data(), content.size());
                if (code == Close) {
                    const std::string reason(content.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(2, length)), content.end());
                    throw Error("the server closed the stream: " + reason, 0);
                }
                continue;
            }
            kind = code != Continued ? code : kind;
            const std::size_t start = message.size();
            message.resize(start + length);
            connection_.read(message.data() + start, length);
            if (is_last) return kind;
        }
    }

    detail::Connection connection_;
    std::random_device random_;
    std::vector<std::array<std::uint32_t, 2>> sizes_;  // width and height of each camera
    std::uint32_t sent_ = 0;
    bool is_broken_ = false;
};

}  // namespace msisf

#endif
