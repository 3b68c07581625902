function errors = closed_loop(host, port, frames)
% CLOSED_LOOP  A Kalman filter finds its way over the Moon by what its camera sees: errors of its position after each frame, m.
%   The same loop, with the same result, as clients/python/examples/closed_loop.py, which explains it:
%       addpath('clients/matlab', 'clients/matlab/examples'); errors = closed_loop('127.0.0.1', 8810, 300);
    if nargin < 3
        frames = 300;
    end
    c = struct('mu', 4.902800066e12, 'spin', 2.6617e-6, 'sphere', 1737400, 'step', 5, ... % m^3/s^2, rad/s (of MOON_ME about z), m, s
        'pixels', 128, 'half', 8, 'search', 6, 'landmarks', 8, 'pixelNoise', 0.4, 'accelerationNoise', 1e-4); % px, px, m/s^2
    camera = '"width": 128, "height": 128, "fov": 40';
    mjd = 55289;
    sun = msisf_ask(host, port, '/v1/sun?mjd=55289');
    start = (sun.sub_solar_point.longitude - 75) * pi / 180; % the Sun stands low first, then higher
    radius = c.sphere + 400e3;
    speed = sqrt(c.mu / radius) - c.spin * radius;
    truth = [radius * cos(start); radius * sin(start); 0; -speed * sin(start); speed * cos(start); 0];
    state = truth + [1500; -1200; 1000; 0.5; -0.5; 0.5];
    covariance = diag([2000^2, 2000^2, 2000^2, 1, 1, 1]);
    eye = MsisfStream(host, port, ['{' camera ', "bit-depth": 16}']);
    mind = MsisfStream(host, port, ['{' camera ', "bit-depth": 16}']);
    errors = zeros(frames, 1);
    for frame = 1:frames
        axes = axes_at(truth(1:3));
        turn = quaternion_of(axes);
        seen = double(eye.render(mjd, truth(1:3), turn));
        expected = double(mind.render(mjd, state(1:3), turn));
        spots = corners(expected, c);
        pixels = zeros(size(spots));
        isGood = false(size(spots, 1), 1);
        for k = 1:size(spots, 1)
            [pixels(k, :), likeness] = find_spot(spots(k, :), expected, seen, c);
            isGood(k) = likeness > 0.8;
        end
        if any(isGood)
            body = sprintf('{"frame": {%s, "fixed-state": [%s]}, "pixels": [%s]}', camera, ...
                list_of([mjd; state(1:3); turn(:)]), strjoin(cellfun(@(spot) ['[' list_of(spot + 1) ']'], ...
                num2cell(spots(isGood, :), 2)', 'UniformOutput', false), ', '));
            answer = msisf_ask(host, port, '/v1/pixels', body);
            points = answer.points;
            if ~iscell(points)
                points = num2cell(points);
            end
            isGround = ~cellfun(@isempty, points(:));
            pixels = pixels(isGood, :);
            points = cellfun(@(point) point.position(:)', points(isGround), 'UniformOutput', false);
            [state, covariance] = update(state, covariance, axes, vertcat(points{:}), pixels(isGround, :), c);
        end
        errors(frame) = norm(state(1:3) - truth(1:3));
        truth = propagate(truth, c);
        [state, covariance] = predict(state, covariance, c);
        mjd = mjd + c.step / 86400;
    end
    delete(eye);
    delete(mind);
    fprintf('error of the position: %.0f m after the first frame, %.0f m after the last\n', errors(1), errors(end));
end

function text = list_of(numbers)
    text = strjoin(arrayfun(@(number) sprintf('%.17g', number), numbers(:)', 'UniformOutput', false), ', ');
end

function change = rate(state, c)
    % Motion in the frame that turns with the Moon.
    position = state(1:3);
    velocity = state(4:6);
    gravity = -c.mu * position / norm(position)^3;
    turning = [2 * c.spin * velocity(2) + c.spin^2 * position(1); -2 * c.spin * velocity(1) + c.spin^2 * position(2); 0];
    change = [velocity; gravity + turning];
end

function state = propagate(state, c)
    % One step of Runge and Kutta's fourth order.
    k1 = rate(state, c);
    k2 = rate(state + 0.5 * c.step * k1, c);
    k3 = rate(state + 0.5 * c.step * k2, c);
    k4 = rate(state + c.step * k3, c);
    state = state + c.step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
end

function axes = axes_at(position)
    % Columns: against the line of sight, right, up; of a camera that looks to the Moon's centre, north up.
    up = position / norm(position);
    east = cross([0; 0; 1], up);
    east = east / norm(east);
    axes = [up, east, cross(up, east)];
end

function q = quaternion_of(m)
    q0 = 0.5 * sqrt(max(0, 1 + trace(m)));
    if q0 > 1e-3
        q = [[m(3, 2) - m(2, 3), m(1, 3) - m(3, 1), m(2, 1) - m(1, 2)] / (4 * q0), q0];
    else
        q = [sqrt(max(0, (1 + diag(m)') / 2)), 0];
    end
end

function found = corners(image, c)
    % The spots with most contrast in both directions, one in each cell of a grid, [n, 2] of x, y, from 0.
    [dx, dy] = gradient(image);
    box = @(values) conv2(values, ones(7), 'same');
    strength = box(dx .* dx) .* box(dy .* dy) - box(dx .* dy).^2;
    border = c.half + c.search + 1;
    cell = c.pixels / 4;
    found = zeros(0, 3);
    for top = border:cell:c.pixels - border - 2
        for left = border:cell:c.pixels - border - 2
            part = strength(top + 1:min(top + cell, c.pixels - border), left + 1:min(left + cell, c.pixels - border))';
            [value, at] = max(part(:)); % of equal ones the first by rows
            [x, y] = ind2sub(size(part), at);
            found(end + 1, :) = [value, left + x - 1, top + y - 1]; %#ok<AGROW>
        end
    end
    found = sortrows(found, [-1, -2, -3]);
    found = found(1:min(c.landmarks, end), 2:3);
end

function [pixel, likeness] = find_spot(spot, expected, seen, c)
    % Where a spot of the expected picture is in the seen one, to a part of a pixel, and how alike the two are (1: the same).
    side = 2 * c.half + 1;
    patch = expected(spot(2) + 1 + (-c.half:c.half), spot(1) + 1 + (-c.half:c.half));
    patch = patch - mean(patch(:));
    reach = c.half + c.search;
    area = seen(spot(2) + 1 + (-reach:reach), spot(1) + 1 + (-reach:reach));
    sums = @(values) conv2(values, ones(side), 'valid');
    squares = sums(area.^2) - sums(area).^2 / side^2;
    alike = conv2(area, rot90(patch, 2), 'valid') ./ (sqrt(max(squares, 0) * sum(patch(:).^2)) + 1e-9);
    [~, at] = max(reshape(alike', [], 1));
    [column, row] = ind2sub(size(alike'), at);
    pixel = spot;
    likeness = 0;
    if row > 1 && row < size(alike, 1) && column > 1 && column < size(alike, 2)
        likeness = alike(row, column);
        pixel = spot + [column - 1 - c.search + vertex(alike(row, column - 1:column + 1)), ...
            row - 1 - c.search + vertex(alike(row - 1:row + 1, column))];
    end
end

function shift = vertex(three)
    % Where the parabola through three values has its top.
    curvature = three(1) - 2 * three(2) + three(3);
    shift = 0;
    if curvature < 0
        shift = 0.5 * (three(1) - three(3)) / curvature;
    end
end

function [after, covariance] = predict(state, covariance, c)
    after = propagate(state, c);
    transition = zeros(6);
    steps = [1, 1, 1, 1e-3, 1e-3, 1e-3];
    for k = 1:6
        moved = state;
        moved(k) = moved(k) + steps(k);
        transition(:, k) = (propagate(moved, c) - after) / steps(k);
    end
    noise = [0.5 * c.step^2 * eye(3); c.step * eye(3)] * c.accelerationNoise;
    covariance = transition * covariance * transition' + noise * noise';
end

function [state, covariance] = update(state, covariance, axes, points, pixels, c)
    % Corrects by points (m) that are seen at pixels, from 0, by a camera with these axes at the state's position.
    if isempty(points)
        return
    end
    focal = 0.5 * c.pixels / tan(20 * pi / 180);
    fromMoon = [axes(:, 2), -axes(:, 3), -axes(:, 1)]'; % x right, y down, z ahead
    count = size(points, 1);
    design = zeros(2 * count, 6);
    innovation = zeros(2 * count, 1);
    for k = 1:count
        p = fromMoon * (points(k, :)' - state(1:3));
        at = 2 * k + (-1:0);
        innovation(at) = pixels(k, :)' - (focal * p(1:2) / p(3) + 0.5 * (c.pixels - 1));
        design(at, 1:3) = -[focal / p(3), 0, -focal * p(1) / p(3)^2; 0, focal / p(3), -focal * p(2) / p(3)^2] * fromMoon;
    end
    total = design * covariance * design' + c.pixelNoise^2 * eye(2 * count);
    gain = (total \ (design * covariance))';
    state = state + gain * innovation;
    covariance = (eye(6) - gain * design) * covariance;
end
