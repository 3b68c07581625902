using Msisf.App.Host;
using Msisf.App.Settings;
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
    private ModifiedJulianDate _first;
    private ModifiedJulianDate _last;

    /// <summary>Name of the rig's camera, which the notes begin with; null without a rig.</summary>
    public string? Camera { get; init; }

    /// <summary>Looks at the frames of each camera, and writes the notes.</summary>
    /// <param name="trajectory">Has the epoch of an orbit.</param>
    /// <param name="cameras">The frames that this call makes.</param>
    /// <param name="terrain">The elevation model.</param>
    /// <param name="log">Receives the notes.</param>
    /// <param name="cancellation">Cancels the work between two frames.</param>
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

    /// <summary>Takes one frame.</summary>
    public void Add(Frame frame, FramePreview view)
    {
        _first = _count == 0 || frame.Time.Days < _first.Days ? frame.Time : _first;
        _last = _count == 0 || frame.Time.Days > _last.Days ? frame.Time : _last;
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

    /// <summary>Writes the notes.</summary>
    /// <param name="trajectory">Has the epoch of an orbit; null if that was looked at.</param>
    /// <param name="log">Receives the notes.</param>
    public void Write(TrajectorySettings? trajectory, ILog log)
    {
        if (_withoutMoon.Count > 0)
        {
            Note(_count == 1
                ? "The image does not show the Moon."
                : $"{Frames(_withoutMoon, "does", "do")} not show the Moon{Steps(_withoutMoon)}.");
        }

        if (_besideMap.Count > 0)
        {
            Note((_count == 1
                ? "The image shows nothing of the elevation model"
                : $"{Frames(_besideMap, "shows", "show")} nothing of the elevation model{Steps(_besideMap)}")
                + ", a map of a part of the Moon. Add a model of the whole Moon by a second --ldem, or move the camera.");
        }

        if (_unlit.Count > 0)
        {
            Note(_count == 1
                ? "The image shows no lit ground."
                : $"{Frames(_unlit, "shows", "show")} no lit ground{Steps(_unlit)}.");
        }

        if (_widestCell > WidestCell && !isRefined)
        {
            string step = _count == 1 ? string.Empty : Invariant($" at step {_widestStep}");
            string width = _widestCell < LargestTold
                ? Invariant($"{_widestCell:F0}")
                : Invariant($"more than {LargestTold:F0}");
            string option = hasSeveral || resolution.PixelsPerDegree is null ? string.Empty : " (--res)";
            Note($"Cells of the model are {width} px wide in the image{step}: a finer model{option} would show more.");
        }

        if (trajectory is OrbitSettings orbit && EpochAway(orbit.Epoch) is { } away)
        {
            log.Note($"The epoch is {away}: a real orbit has long left the two-body one by then.");
        }

        void Note(string text) => log.Note(Camera is null ? text : $"{Camera}: {text}");
    }

    private string? EpochAway(ModifiedJulianDate epoch) =>
        _first.Days - epoch.Days > FarEpoch ? $"{Duration(_first.Days - epoch.Days)} before the first frame"
        : epoch.Days - _last.Days > FarEpoch ? $"{Duration(epoch.Days - _last.Days)} after the last frame"
        : null;

    private static string Duration(double days) => days < 2.0 * DaysPerYear
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
