function answer = msisf_ask(host, port, path, body, token)
% MSISF_ASK  What the server (msis serve) answers to a question in JSON: docs/server.md has the paths.
%   sun    = msisf_ask('127.0.0.1', 8810, '/v1/sun?mjd=55289');
%   ground = msisf_ask('127.0.0.1', 8810, '/v1/pixels', '{"frame": {...}, "pixels": [[512.5, 384]]}');
%   ...    = msisf_ask(host, port, path, body, token)   for a server with a token
% An error 'msisf:request' has the words of the server. In MATLAB webread and webwrite do the same; Octave's webwrite sends no JSON.
    socket = tcpclient(host, port, 'Timeout', 120);
    method = 'GET';
    headers = sprintf('Host: localhost\r\nX-Msisf-Client: %s\r\nAccept: application/json\r\nConnection: close\r\n', msisf_client_name());
    content = zeros(1, 0, 'uint8');
    if nargin > 3 && ~isempty(body)
        method = 'POST';
        content = unicode2native(body, 'UTF-8');
        headers = sprintf('%sContent-Type: application/json\r\nContent-Length: %d\r\n', headers, numel(content));
    end
    if nargin > 4
        headers = sprintf('%sAuthorization: Bearer %s\r\n', headers, token);
    end
    write(socket, [uint8(sprintf('%s %s HTTP/1.1\r\n%s\r\n', method, path, headers)), uint8(content)]);
    [status, length] = head_of(read_until(socket, sprintf('\r\n\r\n')));
    if isnan(length)
        text = '';
        size = hex2dec(strtok(read_until(socket, sprintf('\r\n'))));
        while size > 0
            text = [text, take(socket, size)]; %#ok<AGROW>
            take(socket, 2);
            size = hex2dec(strtok(read_until(socket, sprintf('\r\n'))));
        end
    else
        text = take(socket, length);
    end
    try
        answer = jsondecode(native2unicode(uint8(text), 'UTF-8'));
    catch problem
        error('msisf:server', '%s%s: the answer is no JSON (%s)', host, path, problem.message);
    end
    if status ~= 200
        if ~isfield(answer, 'detail')
            answer.detail = sprintf('the server answers with status %d', status);
        end
        error('msisf:request', '%s', answer.detail);
    end
end

function [status, length] = head_of(head)
    status = sscanf(head, 'HTTP/1.1 %d');
    if isempty(status)
        error('msisf:server', 'the answer is no HTTP: %s', strtok(head, sprintf('\r')));
    end
    length = NaN; % in pieces
    words = regexp(head, '(?i)\ncontent-length: *(\d+)', 'tokens', 'once');
    if ~isempty(words)
        length = str2double(words{1});
    elseif isempty(regexp(head, '(?i)\ntransfer-encoding: *chunked', 'once'))
        error('msisf:server', 'the answer does not say how long it is');
    end
end

function text = read_until(socket, ending)
    text = '';
    while numel(text) < numel(ending) || ~strcmp(text(end - numel(ending) + 1:end), ending)
        text = [text, take(socket, 1)]; %#ok<AGROW>
        if numel(text) > 65536
            error('msisf:server', 'the head of the answer is too long');
        end
    end
end

function text = take(socket, count)
    text = '';
    while numel(text) < count
        more = read(socket, count - numel(text));
        if isempty(more)
            error('msisf:server', 'the server closed the connection, or was silent too long');
        end
        text = [text, char(more(:)')]; %#ok<AGROW>
    end
end
