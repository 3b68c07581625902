using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.App.Tests.Host;
using Msisf.App.Tests.Settings;
using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Preview;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.App.Tests.Preparation;

public sealed class RunNotesTests
{
    private const double Height = 1e5;
    private const double Fov = 0.5;

    private static readonly SceneLight Sun = new(new Vector3D(1.5e11, 0.0, 0.0), IsSun: true);
    private static readonly Vector3D Day = new(MoonConstants.ReferenceRadius + Height, 0.0, 0.0);
    private static readonly UnitQuaternion Outward = NadirPointing.MoonFromCamera(-Day);

    [Fact]
    public void Write_AFrameByDay_SaysNothing() => Assert.Empty(Notes(64, ByDay(1)));

    [Fact]
    public void Write_OneFrame_SpeaksOfTheImage()
    {
        Assert.Equal(["The image shows no lit ground."], Notes(64, AtNight(1)));
        Assert.Equal(["The image does not show the Moon."], Notes(64, LookingAway(1)));
    }

    [Fact]
    public void Write_BesideTheMap_SaysWhatToDo()
    {
        RunNotes notes = new(64, hasSeveral: false, isRefined: false);
        notes.Add(ByDay(1), View(ByDay(1)));
        notes.Add(ByDay(2), View(LookingAway(2)) with { IsBesideMap = true });
        ListLog log = new();

        notes.Write(new FixedStateSettings(default, default), log);

        Assert.StartsWith(
            "1 of 2 frames shows nothing of the elevation model (step 2), a map of a part of the Moon. Add a model",
            Assert.Single(log.Lines), StringComparison.Ordinal);
    }

    [Fact]
    public void Write_SomeFrames_NamesTheirSteps()
    {
        string[] notes = Notes(
            64, ByDay(11), AtNight(12), AtNight(13), AtNight(14), LookingAway(15), AtNight(20), ByDay(21));

        Assert.Equal(["1 of 7 frames does not show the Moon (step 15).", "4 of 7 frames show no lit ground (steps 12:14,20)."], notes);
    }

    [Fact]
    public void Write_AllFrames_NamesNoSteps() =>
        Assert.Equal(["2 of 2 frames show no lit ground."], Notes(64, AtNight(1), AtNight(2)));

    [Fact]
    public void Write_ManyScatteredSteps_NamesTheFirst()
    {
        string note = Assert.Single(Notes(64, [.. Enumerable.Range(1, 200).Select(step => step % 2 == 0 ? ByDay(step) : AtNight(step))]));

        Assert.Equal(
            "100 of 200 frames show no lit ground (steps 1,3,5,7,9,11,13,15,17,19,21,23,25,27,29,31,33,35,37,39,41,43, ...).", note);
    }

    /// <summary>A cell of 4 px/deg is 7 581 m; the pixel at 100 km is 2 tan(0.25) 1e5 / 100 = 510.7 m, from 10 km 51.07 m.</summary>
    [Fact]
    public void Write_WideCells_SaysHowWide()
    {
        const string Remedy = "a finer model (--res) would show more, and --look photo invents what it lacks.";
        Assert.Equal(
            [$"Cells of the model are 15 px wide in the image: {Remedy}"], Notes(4, ByDay(1)));
        Assert.Equal(
            [$"Cells of the model are 148 px wide in the image at step 2: {Remedy}"],
            Notes(4, ByDay(1), Of(2, Day with { X = MoonConstants.ReferenceRadius + (0.1 * Height) }, NadirPointing.MoonFromCamera(Day))));
    }

    [Fact]
    public void Write_WideCellsWithInventedDetail_SaysNothing() => Assert.Empty(Notes(4, isRefined: true, ByDay(1)));

    [Theory]
    [InlineData(55289.0, 55300.0, null)]
    [InlineData(55289.0, 55400.0, "111 days before the first frame")]
    [InlineData(55400.0, 55289.0, "111 days after the last frame")]
    [InlineData(55289.0, 65516.0, "28 years before the first frame")]
    public void Write_AFarEpoch_SaysHowFar(double epoch, double time, string? away)
    {
        TrajectorySettings orbit = TrajectorySettingsReader.Read(
            Given.Options($"--kepler-set {{2E6,0,0,0,0,0}} --epoch {epoch} --time {time}"));
        RunNotes notes = new(64, hasSeveral: false, isRefined: false);
        notes.Add(Of(1, Day, NadirPointing.MoonFromCamera(Day)) with { Time = Moments.OfMjd(time) }, View(ByDay(1)));
        ListLog log = new();

        notes.Write(orbit, log);

        Assert.Equal(
            away is null ? [] : [$"The epoch is {away}: a real orbit has long left the two-body one by then."], log.Lines);
    }

    private static Frame ByDay(int step) => Of(step, Day, NadirPointing.MoonFromCamera(Day));

    private static Frame AtNight(int step) => Of(step, -Day, NadirPointing.MoonFromCamera(-Day));

    private static Frame LookingAway(int step) => Of(step, Day, Outward);

    private static Frame Of(int step, Vector3D position, UnitQuaternion moonFromCamera) => new(
        step, $"frame{step}", Moments.OfMjd(55289.0), new PinholeCamera(position, moonFromCamera, Fov, 100, 100), Sun);

    private static FramePreview View(Frame frame) => FramePreview.Of(frame.Camera, frame.Light, terrain: null);

    private static string[] Notes(int pixelsPerDegree, params Frame[] frames) => Notes(pixelsPerDegree, isRefined: false, frames);

    private static string[] Notes(int pixelsPerDegree, bool isRefined, params Frame[] frames)
    {
        RunNotes notes = new(pixelsPerDegree, hasSeveral: false, isRefined);
        foreach (Frame frame in frames)
        {
            notes.Add(frame, View(frame));
        }

        ListLog log = new();
        notes.Write(new FixedStateSettings(default, default), log);
        return [.. log.Lines];
    }
}
