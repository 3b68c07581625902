% Driven by test_matlab.py: writes images of some states as raw bytes, and what goes wrong as text.
% The server at the port dying says no HTTP, and closes.
function run_stream(host, port, folder, dying)
    frame = '{"width": 37, "height": 20, "fov": 33.5, "bit-depth": 16}';
    stream = MsisfStream(host, port, frame, '0123456789abcdef');
    first = stream.render(55289.25, [1.9e6 1e5 -2e5], [0 0 0 1]);
    keep(folder, 'first', first);
    try
        stream.render(55289.25, [1e5 0 0], [0 0 0 1]);
    catch problem
        fprintf('%s\n', problem.message);
    end
    keep(folder, 'second', stream.renderOptions('{"position": [0, 30, 1e5], "time": 55289.5}'));
    try
        stream.render(55289.25, [1e5 0 NaN], [0 0 0 1]);
    catch problem
        fprintf('%s\n', problem.message);
    end
    try
        MsisfStream(host, port, '{"fov": 400}', '0123456789abcdef');
    catch problem
        fprintf('%s\n', problem.message);
    end
    try
        MsisfStream(host, port, frame, 'wrong');
    catch problem
        fprintf('%s\n', problem.message);
    end
    fprintf('%s %d %d\n', class(first), size(first));
    several(host, port, folder);
    wrong = {{port, '/v1/render', '{"width": 0}', '0123456789abcdef'}, {port, '/v1/sun?mjd=55289', '', 'wrong'}, {dying, '/', ''}};
    for k = 1:3
        try
            msisf_ask(host, wrong{k}{:});
        catch problem
            fprintf('%s\n', problem.message);
        end
    end
    try
        MsisfStream(host, dying, frame);
    catch problem
        fprintf('%s\n', problem.message);
    end
end

% A rig: each image has the size and the levels of its own camera, also after a state that is refused.
function several(host, port, folder)
    cameras = ['[{"fov": 40, "offset": [0, -1000, 0]}, ' ...
        '{"fov": 12, "width": 24, "height": 31, "bit-depth": 8, "quaternion": [0, 0, 0.1, 0.99498743710662]}]'];
    stream = MsisfStream(host, port, '{"width": 37, "height": 20, "bit-depth": 16}', '0123456789abcdef', cameras);
    images = stream.render(55289.25, [1.9e6 1e5 -2e5], [0 0 0 1]);
    keep(folder, 'one of several', images{1});
    try
        stream.render(55289.25, [1e5 0 0], [0 0 0 1]);
    catch problem
        fprintf('%s\n', problem.message);
    end
    images = stream.render(55289.25, [1.9e6 1e5 -2e5], [0 0 0 1]);
    keep(folder, 'other of several', images{2});
    fprintf('%s %d %d, %s %d %d\n', class(images{1}), size(images{1}), class(images{2}), size(images{2}));
end

function keep(folder, name, image)
    file = fopen(fullfile(folder, name), 'w');
    fwrite(file, image', class(image));
    fclose(file);
end
