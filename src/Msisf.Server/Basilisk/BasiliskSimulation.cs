using Msisf.Adapters.Camera;
using Msisf.Adapters.Input;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Serving;
using Msisf.App.Settings;
using Msisf.Core.Scene;
using Msisf.Core.Time;
using System.Text.Json;

namespace Msisf.Server.Basilisk;

/// <summary>One simulation: what its last message says, and the images of it.</summary>
/// <param name="note">Receives what the user should know, each text once.</param>
internal sealed class BasiliskSimulation(FrameService frames, BasiliskSettings settings, ILog log, Action<string> note)
{
    private const string MoonName = "moon";
    private const string SunName = "sun";

    /// <summary>degrees: to which a camera file and a message must agree about the field of view; a message has it to 1e-14.</summary>
    private const double FieldOfViewError = 1e-3;

    /// <summary>s: ten thousand years; a simulation that is longer has another unit.</summary>
    private const double LongestSimulation = 3.2e11;

    private static readonly string[] NameEndings = ["_planet_data", "_barycenter"];

    /// <summary>What vizInterface sends if no message is linked to its epochInMsg.</summary>
    private static readonly VizEpoch UsualEpoch = new(2019, 1, 1, 0, 0, 0.0);

    private readonly Dictionary<long, (VizCamera Camera, RequestedFrame Requested)> _requested = [];
    private VizMessage? _message;
    private VizEpoch? _epoch;
    private Task _lastImage = Task.CompletedTask;

    /// <summary>Takes what a SIM_UPDATE says; a wrong one leaves nothing to draw from.</summary>
    /// <param name="bytes">The VizMessage.</param>
    public void Update(byte[] bytes)
    {
        _message = null;
        try
        {
            VizMessage message = VizMessageReader.Read(bytes);
            _epoch = message.Epoch ?? _epoch;
            _message = message;
        }
        catch (BadInputException exception)
        {
            note(exception.Message);
        }
    }

    /// <summary>
    /// Draws the image of a camera from what the last SIM_UPDATE said, after those that were asked for before: a peer that asks
    /// without waiting takes one place of the server's queue, not all. Updates and images are asked for by one thread.
    /// </summary>
    /// <param name="number">Its number; empty for the only camera.</param>
    /// <returns>A PNG; null if there is no image, which has been said.</returns>
    public Task<byte[]?> DrawAsync(string number, CancellationToken cancellation)
    {
        VizMessage? message = _message;
        Task<byte[]?> image = _lastImage.ContinueWith(
            _ => DrawAsync(number, message, cancellation), cancellation, TaskContinuationOptions.None, TaskScheduler.Default).Unwrap();
        _lastImage = image;
        return image;
    }

    private async Task<byte[]?> DrawAsync(string number, VizMessage? last, CancellationToken cancellation)
    {
        try
        {
            VizMessage message = last ?? throw new BadInputException(
                "an image is asked for, but no SIM_UPDATE with a VizMessage came before.");
            VizCamera camera = message.Cameras.FirstOrDefault(
                camera => number.Length == 0 || camera.Id.ToString(CultureInfo.InvariantCulture) == number)
                ?? throw new BadInputException(
                    $"an image of camera {NumberText.Shown(number)} is asked for; the message has "
                        + $"{(message.Cameras.Count == 0 ? "none" : string.Join(", ", message.Cameras.Select(camera => camera.Id)))}.");
            SpacecraftState state = StateOf(message, camera);
            RequestedFrame requested = RequestedOf(camera);
            using Answer answer = frames.Answers.InMemory();
            FixedStateSettings place = new(state.Time.Utc, state) { Noise = requested.Noise };
            IReadOnlyList<string> warnings = frames.CollectWarnings();
            await frames.DrawAsync(requested, place, AnswerForm.Of(AnswerForm.Png), answer, cancellation).ConfigureAwait(false);
            settings.Record?.Add(camera.Id, () => ArgumentsOf(requested), state); // what was refused can't be drawn again
            foreach (string warning in warnings)
            {
                note(warning);
            }

            return answer.Parts[0].Bytes.ToArray();
        }
        catch (Exception exception) when (!cancellation.IsCancellationRequested)
        {
            // A bug gets an answer too: without one Basilisk waits for ever.
            Problem problem = Problem.Of(exception) ?? RequestErrors.Bug(exception, log);
            note($"no image: {Problem.Shortened(problem.Detail)}");
            return null;
        }
    }

    private string ArgumentsOf(RequestedFrame requested)
    {
        using SharedCache<RenderSession>.Lease session = frames.Sessions.Rent(requested);
        return session.Value.Arguments;
    }

    private SpacecraftState StateOf(VizMessage message, VizCamera camera)
    {
        if (camera.RenderMode != 0)
        {
            throw new BadInputException(Invariant(
                $"camera {camera.Id} has renderMode {camera.RenderMode}; msis draws images (0). For depths take the layers of 'msis' or of "
                    + $"the stream (docs/server.md)."));
        }

        VizBody moon = BodyOf(message, MoonName);
        VizBody sun = BodyOf(message, SunName);
        foreach (VizBody other in message.Bodies.Where(body => body != moon && body != sun))
        {
            note($"{other.Name} is left out: msis draws the Moon only.");
        }

        VizSpacecraft craft = CraftOf(message, camera);
        EphemerisSource ephemeris = frames.Sessions.Ephemeris.Of(RequestedOf(camera).Settings);
        Instant time = TimeOf(message, ephemeris.TimeScale());
        UnitQuaternion moonFromInertial = VizGeometry.MoonFromInertial(moon);
        if (settings.MoonAttitude == MoonAttitude.Spice)
        {
            RotationMatrix spice = ephemeris.Engine().BodyFromJ2000(time.Tdb);
            moonFromInertial = VizGeometry.Checked(moonFromInertial, UnitQuaternion.FromMatrix(spice), time);
        }
        else if (moonFromInertial == UnitQuaternion.Identity)
        {
            note("the Moon's rotation is the identity: no attitude is given, so the simulation's axes are taken as the Moon's.");
        }
        else
        {
            note("the Moon's rotation of the message is taken as MOON_ME. If it is IAU_MOON, as Basilisk's default, the ground is up to "
                + "154 m off; --moon-attitude spice takes MOON_ME of the kernels.");
        }

        return VizGeometry.StateOf(camera, craft, moon, sun, moonFromInertial, time);
    }

    private Instant TimeOf(VizMessage message, TimeScale scale)
    {
        if (_epoch is null)
        {
            note("no message had an epoch; 2019-01-01T00:00:00Z is taken, as vizInterface does.");
            _epoch = UsualEpoch;
        }

        try
        {
            double seconds = (3600.0 * _epoch.Hours) + (60.0 * _epoch.Minutes) + _epoch.Seconds;
            DateOnly day = new(_epoch.Year, _epoch.Month, _epoch.Day);
            return Math.Abs(seconds) + Math.Abs(message.SimulationSeconds) < LongestSimulation
                ? scale.InstantOf(CalendarTime.Of(day, (decimal)seconds)).After(message.SimulationSeconds)
                : throw new BadInputException(Invariant(
                    $"the time of the message is {seconds + message.SimulationSeconds:R} s after the epoch's day; that is not a time."));
        }
        catch (ArgumentOutOfRangeException exception)
        {
            throw new BadInputException($"the epoch {_epoch.Year}-{_epoch.Month}-{_epoch.Day} is not a date.", exception);
        }
    }

    private static VizBody BodyOf(VizMessage message, string name) => message.Bodies.FirstOrDefault(
        body => NameEndings.Aggregate(body.Name, (shortened, ending) => shortened.EndsWith(ending, StringComparison.OrdinalIgnoreCase)
            ? shortened[..^ending.Length]
            : shortened).Equals(name, StringComparison.OrdinalIgnoreCase))
        ?? throw new BadInputException(
            $"the message has no body '{name}' ({string.Join(", ", message.Bodies.Select(body => body.Name))}). Add it to the simulation's "
                + "gravity bodies, with SPICE or a state of your own.");

    private VizSpacecraft CraftOf(VizMessage message, VizCamera camera)
    {
        string names = string.Join(", ", message.Spacecraft.Select(craft => craft.Name));
        if (message.Spacecraft.FirstOrDefault(craft => craft.Name == camera.Parent) is { } parent)
        {
            return parent;
        }

        if (camera.Parent.Length == 0 && message.Spacecraft.Count > 0)
        {
            note($"camera {camera.Id} names no spacecraft; {message.Spacecraft[0].Name}, the first one, is taken.");
            return message.Spacecraft[0];
        }

        throw new BadInputException($"camera {camera.Id} is on '{camera.Parent}'; the message has {(names.Length > 0 ? names : "none")}.");
    }

    /// <summary>The options of a camera's images: its field of view and size are the message's, the rest is the user's.</summary>
    private RequestedFrame RequestedOf(VizCamera camera)
    {
        lock (_requested) // vizInterface asks for one image at a time, others may not
        {
            return RequestedOnceOf(camera);
        }
    }

    private RequestedFrame RequestedOnceOf(VizCamera camera)
    {
        if (_requested.TryGetValue(camera.Id, out (VizCamera Camera, RequestedFrame Requested) known)
            && known.Camera.FieldOfViewDegrees == camera.FieldOfViewDegrees && known.Camera.Width == camera.Width
            && known.Camera.Height == camera.Height)
        {
            return known.Requested;
        }

        if (!(camera.FieldOfViewDegrees is > 0.0 and < 180.0) || camera.Width <= 0 || camera.Height <= 0)
        {
            throw new BadInputException(Invariant(
                $"camera {camera.Id} has {camera.Width} x {camera.Height} px and a field of view of {camera.FieldOfViewDegrees:R} degrees; "
                    + $"a size from 1 px, and degrees between 0 and 180 are needed."));
        }

        Dictionary<string, JsonElement> options = new(settings.FrameOptions, StringComparer.Ordinal);
        if (settings.Cameras.TryGetValue(camera.Id, out CameraFile? file))
        {
            Compare(camera, file);
            options["camera"] = JsonSerializer.SerializeToElement(file.Name, AnswerTypes.Default.String);
        }
        else
        {
            options["width"] = JsonSerializer.SerializeToElement(camera.Width, AnswerTypes.Default.Int64);
            options["height"] = JsonSerializer.SerializeToElement(camera.Height, AnswerTypes.Default.Int64);
            options["fov"] = JsonSerializer.SerializeToElement(HorizontalDegrees(camera), AnswerTypes.Default.Double);
        }

        JsonElement json = JsonSerializer.SerializeToElement(options, AnswerTypes.Default.DictionaryStringJsonElement);
        RequestedFrame requested = frames.Read(json, needsPlace: false);
        _requested[camera.Id] = (camera, requested);
        return requested;
    }

    /// <summary>The horizontal field of view of a camera with square pixels, whose vertical one the message has.</summary>
    private static double HorizontalDegrees(VizCamera camera)
    {
        double aspect = (double)camera.Width / camera.Height;
        return camera.Width == camera.Height
            ? camera.FieldOfViewDegrees // without rounding
            : double.RadiansToDegrees(2.0 * Math.Atan(aspect * Math.Tan(double.DegreesToRadians(camera.FieldOfViewDegrees) / 2.0)));
    }

    private static void Compare(VizCamera camera, CameraFile file)
    {
        double vertical = double.RadiansToDegrees(2.0 * Math.Atan(file.Model.Height / (2.0 * file.Model.FocalY)));
        if (file.Model.Width != camera.Width || file.Model.Height != camera.Height
            || Math.Abs(vertical - camera.FieldOfViewDegrees) > FieldOfViewError)
        {
            throw new BadInputException(Invariant(
                $"camera {camera.Id} has {camera.Width} x {camera.Height} px and a vertical field of view of {camera.FieldOfViewDegrees:R} "
                    + $"degrees in the simulation, {file.Model.Width} x {file.Model.Height} px and {vertical:R} degrees in {file.Path}. "
                    + $"Mend one of them."));
        }
    }
}
