using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.Core.Orbit;
using Msisf.Core.Preview;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Time;

namespace Msisf.App.Preparation;

/// <summary>
/// What is striking about the frames of a run and often a mistake: the Moon or the map not in the image, no lit ground, cells that are too
/// wide, an epoch that is too far away. Each is said once.
/// </summary>
/// <param name="resolution">Resolution of the elevation model, of several that of the finest.</param>
/// <param name="hasSeveral">Whether there are several.</param>
/// <param name="isRefined">Whether there is invented detail below it, so that no cell is wide.</param>
internal sealed class RunNotes(GridResolution resolution, bool hasSeveral, bool isRefined)
{
    /// <summary>px: wider cells show as facets in the image.</summary>
    private const double WidestCell = 10.0;

    /// <summary>px: a camera that almost touches the ground has no sensible number of pixels a cell.</summary>
    private const double LargestTold = 10000.0;

    /// <summary>
    /// Days: the Moon's uneven gravity turns a low orbit by about a degree a day, so that after this time the two-body orbit says nothing
    /// of the real one.
    /// </summary>
    private const double FarEpoch = 30.0;

    private const double DaysPerYear = 365.25;

    /// <summary>Maximum length of a list of steps; the steps of a frame here and there need more room than a line has.</summary>
    private const int LongestList = 60;

    private readonly List<int> _withoutMoon = [];
    private readonly List<int> _besideMap = [];
    private readonly List<int> _unlit = [];
    private int _count;
    private double _widestCell;
    private int _widestStep;
    private Instant _first;
    private Instant _last;

    /// <summary>Name of the rig's camera, which the notes begin with; null without a rig.</summary>
    public string? Camera { get; init; }

    /// <summary>Looks at the frames of each camera, and writes the notes.</summary>
    /// <param name="trajectory">Has the epoch of an orbit.</param>
    /// <param name="cameras">The frames that this call makes.</param>
    /// <param name="terrain">The elevation model.</param>
    public static void Write(
        TrajectorySettings trajectory, IReadOnlyList<RunFrames> cameras, ITerrain terrain, ILog log, CancellationToken cancellation)
    {
        foreach (RunFrames camera in cameras)
        {
            RunNotes notes = new(terrain.Resolution, terrain.PartCount > 1, terrain.InventedName is not null)
            {
                Camera = camera.Settings.Rig?.Name,
            };
            foreach (Frame frame in camera.Frames)
            {
                cancellation.ThrowIfCancellationRequested();
                notes.Add(frame, FramePreview.Of(frame.Camera, frame.Light, terrain));
            }

            notes.Write(camera == cameras[0] ? trajectory : null, log);
        }
    }

    public void Add(Frame frame, FramePreview view)
    {
        _first = _count == 0 || frame.Time < _first ? frame.Time : _first;
        _last = _count == 0 || frame.Time > _last ? frame.Time : _last;
        _count++;
        if (view.IsBesideMap)
        {
            _besideMap.Add(frame.Step);
        }
        else if (view.Share.Lit is null)
        {
            _withoutMoon.Add(frame.Step);
        }
        else if (view.Share.Lit == 0.0)
        {
            _unlit.Add(frame.Step);
        }

        if (view.PixelsPerCell(resolution) is { } cell && cell > _widestCell)
        {
            (_widestCell, _widestStep) = (cell, frame.Step);
        }
    }

    /// <param name="trajectory">Has the epoch of an orbit; null if that was looked at.</param>
    public void Write(TrajectorySettings? trajectory, ILog log)
    {
        NoteOf(_withoutMoon, "does", "do", "not show the Moon", ".");
        NoteOf(
            _besideMap, "shows", "show", "nothing of the elevation model",
            ", a map of a part of the Moon. Add a model of the whole Moon by a second --ldem, or move the camera.");
        NoteOf(_unlit, "shows", "show", "no lit ground", ".");
        if (_widestCell > WidestCell && !isRefined)
        {
            string step = _count == 1 ? string.Empty : Invariant($" at step {_widestStep}");
            string width = _widestCell < LargestTold
                ? Invariant($"{_widestCell:F0}")
                : Invariant($"more than {LargestTold:F0}");
            string option = hasSeveral || resolution.PixelsPerDegree is null ? string.Empty : " (--res)";
            Note($"Cells of the model are {width} px wide in the image{step}: a finer model{option} would show more, and "
                + $"--look photo invents what it lacks.");
        }

        if (trajectory is OrbitSettings orbit && EpochAway(orbit.Epoch) is { } away)
        {
            log.Note($"The epoch is {away}: a real orbit has long left the two-body one by then.");
        }

        void NoteOf(List<int> steps, string verbOfOne, string verbOfMany, string what, string end)
        {
            if (steps.Count > 0)
            {
                Note(_count == 1
                    ? $"The image {verbOfOne} {what}{end}"
                    : $"{Frames(steps, verbOfOne, verbOfMany)} {what}{Steps(steps)}{end}");
            }
        }

        void Note(string text) => log.Note(Camera is null ? text : $"{Camera}: {text}");
    }

    private string? EpochAway(CalendarTime epoch)
    {
        (double before, double after) = ((_first.Utc - epoch) / Duration.Day, (epoch - _last.Utc) / Duration.Day);
        return before > FarEpoch ? $"{Days(before)} before the first frame"
            : after > FarEpoch ? $"{Days(after)} after the last frame"
            : null;
    }

    private static string Days(double days) => days < 2.0 * DaysPerYear
        ? Invariant($"{days:F0} days")
        : Invariant($"{days / DaysPerYear:F0} years");

    private string Frames(List<int> steps, string verbOfOne, string verbOfMany) => Invariant(
        $"{steps.Count} of {_count} frames {(steps.Count == 1 ? verbOfOne : verbOfMany)}");

    /// <summary>The steps as <c>--frames</c> takes them; empty if they are all.</summary>
    private string Steps(List<int> steps)
    {
        if (steps.Count == _count)
        {
            return string.Empty;
        }

        string text = StepRanges.Of(steps).ToString();
        int end = text.Length <= LongestList ? text.Length : text.LastIndexOf(',', LongestList);
        return $" ({(steps.Count == 1 ? "step" : "steps")} {text[..end]}{(end < text.Length ? ", ..." : string.Empty)})";
    }
}

/// <summary>Notes on the frames of an orbit whose defaults a user may not expect.</summary>
internal static class OrbitNotes
{
    /// <summary>Times longer than this are given in days, s.</summary>
    private const double LongestInHours = 2.0 * 86400.0;

    /// <summary>All notes that apply.</summary>
    /// <param name="orbit">The orbit; its times are computed once each.</param>
    public static IEnumerable<string> Of(OrbitSettings orbit)
    {
        double seconds = orbit.Times.Select(time => Math.Abs((time - orbit.Epoch).TotalSeconds)).DefaultIfEmpty().Max();
        if (orbit.Frame == OrbitFrame.MoonMe && !orbit.IsFrameGiven && seconds > 0.0)
        {
            yield return $"the orbit is propagated in Moon axes that turn with the Moon (the default, {CameraOptions.OrbitFrame.Name} "
                + $"moon-me, as in the thesis): {Cost(seconds)}. For a real orbit take {CameraOptions.OrbitFrame.Name} moon-me-epoch "
                + "(given in the Moon's axes of the epoch) or j2000.";
        }

        if (orbit.Attitude is not null && orbit.AttitudeFrame is null && orbit.Frame != OrbitFrame.MoonMe)
        {
            yield return "--attitude is taken in Moon axes that turn with the Moon (the default, "
                + $"{CameraOptions.AttitudeFrame.Name} moon-me), the orbit in {CameraOptions.OrbitFrame.WordOf(orbit.Frame)}. "
                + $"{CameraOptions.AttitudeFrame.Name} names other axes.";
        }
    }

    /// <summary>How far the ground track moves away from that of a real orbit.</summary>
    private static string Cost(double seconds)
    {
        double angle = MoonConstants.RotationRate * seconds;
        string time = seconds < LongestInHours
            ? Invariant($"{seconds / 3600.0:G3} h")
            : Invariant($"{seconds / 86400.0:G4} days");
        string distance = angle < Math.PI
            ? Invariant($"{double.RadiansToDegrees(angle):G3} degrees, up to {MoonConstants.ReferenceRadius * angle / 1000.0:G3} km")
            : Invariant($"{angle / (2.0 * Math.PI):G3} turns of the Moon");
        return $"{time} from the epoch its ground track is off by {distance}";
    }
}
