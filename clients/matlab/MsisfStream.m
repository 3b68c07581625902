classdef MsisfStream < handle
    % MsisfStream  Images of the Moon from a server (msis serve), in lock-step: a state goes in, its image comes out.
    %
    %   stream = MsisfStream('127.0.0.1', 8810, '{"width": 1024, "height": 1024, "fov": 40}');
    %   image = stream.render(55289.25, [1.9e6 0 0], [0 0 0 1]);
    %
    % The third argument has the options of all images, as JSON (docs/server.md); a fourth one is the token of the server, or ''. A fifth
    % one has several cameras, as a JSON list of what each has of its own, '[{"fov": 5, "quaternion": [0, 0, 0, 1], "offset": [0, 1, 0]}]'
    % (docs/cameras.md): then an image is a cell array with that of each. Units: m, days (MJD, UTC); frame MOON_ME.
    % docs/clients.md says what was run in Octave and what was not in MATLAB.

    properties (SetAccess = private)
        Width = 0;      % px, of each camera
        Height = 0;     % px, of each camera
        IsOpen = false; % false after an error of the connection; errors 'msisf:request' leave the stream open
    end

    properties (Access = private)
        Socket;
        Sent = 0;
        Kept = zeros(1, 0, 'uint8'); % bytes that were read with the head of the answer
    end

    methods
        function stream = MsisfStream(host, port, frame, token, cameras)
            stream.Socket = tcpclient(host, port, 'Timeout', 120);
            authorization = '';
            if nargin > 3 && ~isempty(token)
                authorization = sprintf('Authorization: Bearer %s\r\n', token);
            end
            % The nonce only guards against caches between client and server, so the answer's hash of it is not looked at.
            request = sprintf(['GET /v1/stream HTTP/1.1\r\nHost: localhost\r\nX-Msisf-Client: %s\r\n%sUpgrade: websocket\r\n' ...
                'Connection: Upgrade\r\nSec-WebSocket-Key: bXNpc2ZfbWF0bGFiXzAwMQ==\r\nSec-WebSocket-Version: 13\r\n\r\n'], ...
                msisf_client_name(), authorization);
            write(stream.Socket, uint8(request));
            head = stream.readHead();
            if isempty(strfind(head, ' 101 '))
                error('msisf:server', 'the server refuses the stream: %s', strtok(head, sprintf('\r')));
            end
            stream.IsOpen = true;
            several = '';
            if nargin > 4
                several = sprintf(', "cameras": %s', cameras);
            end
            stream.sendMessage(1, uint8(sprintf('{"frame": %s%s, "mode": "lock-step", "format": "u8"}', frame, several)));
            answer = stream.textOf(stream.receive());
            stream.IsOpen = isfield(answer, 'width');
            if ~stream.IsOpen
                error('msisf:request', '%s', answer.error);
            end
            sizes = answer;
            if nargin > 4
                sizes = answer.cameras;
            end
            stream.Width = [sizes.width];
            stream.Height = [sizes.height];
        end

        function image = render(stream, mjd, position, quaternion, motion)
            % RENDER  Grey levels [height, width], uint8 or uint16, of a state.
            %   mjd         days, UTC
            %   position    m, [1, 3]
            %   quaternion  qx qy qz q0: from camera axes (looks along -x, y right, z up) to MOON_ME, [1, 4]
            %   motion      m/s over the Moon and rad/s about the camera's axes, [1, 6]; only for a camera with a shutter
            if nargin < 5
                motion = [];
            end
            numbers = double([mjd, position(:)', quaternion(:)', motion(:)']);
            if ~any(numel(numbers) == [8, 14]) || ~all(isfinite(numbers))
                error('msisf:request', 'a state is mjd, position (3), quaternion (4) and, for a shutter, motion (6), all finite');
            end
            image = stream.ask(2, typecast(numbers, 'uint8'));
        end

        function image = renderOptions(stream, changes)
            % RENDEROPTIONS  The image of changed options, as JSON, e.g. '{"position": [0, 30, 1e5], "time": 55289.5}'.
            image = stream.ask(1, uint8(changes));
        end

        function delete(stream)
            if stream.IsOpen
                stream.IsOpen = false;
                stream.sendMessage(8, uint8([3, 232])); % 1000: a normal end
            end
            stream.Socket = [];
        end
    end

    methods (Access = private)
        function image = ask(stream, kind, content)
            if ~stream.IsOpen
                error('msisf:server', 'the stream is closed after an error; open another one');
            end
            stream.IsOpen = false; % until the answer is here whole: a late one would be taken for that of the next state
            stream.sendMessage(kind, content);
            stream.Sent = stream.Sent + 1;
            images = cell(1, numel(stream.Width));
            for camera = 1:numel(images)
                images{camera} = stream.next(stream.Width(camera), stream.Height(camera));
            end
            stream.IsOpen = true;
            image = images;
            if numel(images) == 1
                image = images{1};
            end
        end

        function image = next(stream, width, height)
            [message, isText] = stream.receive();
            if isText
                stream.IsOpen = true;
                answer = stream.textOf(message);
                error('msisf:request', '%s', answer.error);
            end
            pixels = width * height;
            length = numel(message) - 16;
            if length < 0 || ~isequal(char(message(1:4)), 'MSIF') || ~any(length == [pixels, 2 * pixels])
                error('msisf:server', 'the server''s message is no image of this stream');
            end
            number = double(typecast(message(5:8), 'uint32'));
            if number ~= stream.Sent
                error('msisf:server', 'the image has number %d, %d is due', number, stream.Sent);
            end
            levels = message(17:end);
            if length == 2 * pixels
                levels = typecast(levels, 'uint16');
            end
            image = reshape(levels, width, height)';
        end

        function sendMessage(stream, kind, content)
            length = numel(content);
            if length < 126
                head = uint8([128 + kind, 128 + length]);
            elseif length < 65536
                head = uint8([128 + kind, 254, floor(length / 256), mod(length, 256)]);
            else
                error('msisf:request', 'a message of %d bytes; a stream takes less than 65536', length);
            end
            mask = uint8(floor(256 * rand(1, 4)));
            masked = bitxor(uint8(content(:)'), mask(mod(0:length - 1, 4) + 1));
            write(stream.Socket, [head, mask, masked]);
        end

        function [message, isText] = receive(stream)
            % The next message, put together from its fragments.
            message = zeros(1, 0, 'uint8');
            isText = false;
            while true
                head = double(stream.take(2));
                code = mod(head(1), 16);
                length = mod(head(2), 128);
                if length == 126
                    length = [256, 1] * double(stream.take(2))';
                elseif length == 127
                    length = 256 .^ (7:-1:0) * double(stream.take(8))';
                end
                if length > 2 * max(stream.Width .* stream.Height) + 2^20
                    error('msisf:server', 'the server''s message is too long');
                end
                content = stream.take(length);
                if code == 9
                    stream.sendMessage(10, content);
                elseif code == 8
                    stream.IsOpen = false;
                    error('msisf:server', 'the server closed the stream: %s', char(content(3:end)));
                elseif code < 8
                    if code > 0
                        isText = code == 1;
                    end
                    message = [message, content]; %#ok<AGROW>
                    if head(1) >= 128
                        return
                    end
                end
            end
        end

        function bytes = take(stream, count)
            kept = min(count, numel(stream.Kept));
            bytes = stream.Kept(1:kept);
            stream.Kept = stream.Kept(kept + 1:end);
            while numel(bytes) < count
                more = uint8(read(stream.Socket, count - numel(bytes)));
                if isempty(more)
                    error('msisf:server', 'the server closed the connection, or was silent too long');
                end
                bytes = [bytes, more(:)']; %#ok<AGROW>
            end
        end

        function head = readHead(stream)
            head = '';
            ending = sprintf('\r\n\r\n');
            while numel(head) < 65536 && (numel(head) < 4 || ~strcmp(head(end - 3:end), ending))
                head = [head, char(stream.take(1))]; %#ok<AGROW>
            end
        end
    end

    methods (Static, Access = private)
        function answer = textOf(message)
            answer = jsondecode(char(message));
        end
    end
end
