using Msisf.Adapters.Manifest;
using Msisf.Adapters.Raster.Heights;
using Msisf.App.Series;
using Msisf.Core.Metadata;
using Msisf.Core.Scene;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.App.Tests.Series;

/// <summary>Keys of runs and frames: the same for the same work, another for each thing that changes it.</summary>
public sealed class RunPlanTests
{
    private static readonly SpacecraftState First = Moments.StateOf([55289, 2e6, 0, 0, 0, 0, 0, 1]);

    private static readonly SpacecraftState Second = Moments.StateOf([55289.5, 2e6, 0, 0, 0, 0, 0, 1]);

    private static readonly RunPlan Plan = Of([First, Second], ["a", "b"], Identity());

    [Fact]
    public void Keys_SameStatesNamesAndSettings_AreTheSame()
    {
        RunPlan again = Of([First, Second], ["a", "b"], Identity());

        Assert.Equal(Plan.Key, again.Key);
        Assert.Equal(Plan.FrameKey(1), again.FrameKey(1));
        Assert.Matches("^[0-9a-f]{32}$", Plan.Key);
        Assert.NotEqual(Plan.FrameKey(1), Plan.FrameKey(2));
    }

    public static TheoryData<string> Settings => ["version", "arguments", "model", "engine", "kernel", "povray", "input"];

    [Theory]
    [MemberData(nameof(Settings))]
    public void Keys_AnyOtherSetting_AreOthers(string changed)
    {
        RunPlan other = Of([First, Second], ["a", "b"], Identity(changed));

        Assert.NotEqual(Plan.IdentityOf(0).Record.Key, other.IdentityOf(0).Record.Key);
        Assert.NotEqual(Plan.Key, other.Key);
        Assert.NotEqual(Plan.FrameKey(1), other.FrameKey(1));
    }

    /// <summary>The name of a frame is no part of what is in it.</summary>
    [Fact]
    public void Keys_OtherNames_AreThoseOfAnotherRunOfTheSameFrames()
    {
        RunPlan other = Of([First, Second], ["c", "d"], Identity());

        Assert.NotEqual(Plan.Key, other.Key);
        Assert.Equal(Plan.FrameKey(2), other.FrameKey(2));
    }

    [Fact]
    public void Keys_NeighbouringDouble_IsAnotherState()
    {
        SpacecraftState near = Moments.StateOf([55289, Math.BitIncrement(2e6), 0, 0, 0, 0, 0, 1]);

        Assert.NotEqual(Plan.FrameKey(1), Of([near], ["a"], Identity()).FrameKey(1));
    }

    [Fact]
    public void Registration_NewRun_HasSettingsRunAndFrames_KnownOneHasNothing()
    {
        ManifestContent known = new();
        ManifestRecord[] news = [.. Plan.Registration(known)];
        Assert.Equal(
            [typeof(SettingsRecord), typeof(RunRecord), typeof(ExpectedRecord), typeof(ExpectedRecord)],
            news.Select(record => record.GetType()));
        foreach (ManifestRecord record in news)
        {
            known.Add(record);
        }

        Assert.Empty(Plan.Registration(known));

        // Another run takes the name over; its own settings are known already.
        ManifestRecord[] others = [.. Of([Second], ["a"], Identity()).Registration(known)];
        Assert.Equal([typeof(RunRecord), typeof(ExpectedRecord)], others.Select(record => record.GetType()));
        known.Add(others[1]);
        Assert.Equal(3, Plan.Registration(known).Count);
    }

    /// <summary>The cameras of a rig are one run, in which each step has a frame of each.</summary>
    [Fact]
    public void Registration_Rig_HasOneRunWithTheSettingsOfEachCamera()
    {
        PlannedCamera left = new([First, Second], ["a1", "a2"], Identity());
        PlannedCamera right = new([First, Second], ["b1", "b2"], Identity("arguments"));
        RunPlan rig = new([left, right]);
        ManifestRecord[] news = [.. rig.Registration(new ManifestContent())];

        Assert.Equal(["a1", "b1", "a2", "b2"], news.OfType<ExpectedRecord>().Select(frame => frame.Name));
        Assert.Equal([1, 1, 2, 2], news.OfType<ExpectedRecord>().Select(frame => frame.Step));
        Assert.Equal(2, news.OfType<SettingsRecord>().Count());
        Assert.Equal(4, Assert.Single(news.OfType<RunRecord>()).Frames);
        Assert.NotEqual(rig.FrameKey(1), rig.FrameKey(1, camera: 1));
        Assert.NotEqual(rig.Key, new RunPlan([right, left]).Key);
    }

    private static RunPlan Of(SpacecraftState[] states, string[] names, RunIdentity identity) =>
        new([new PlannedCamera(states, names, identity)]);

    private static RunIdentity Identity(string changed = "")
    {
        string Of(string name) => changed == name ? $"another {name}" : name;
        return RunIdentity.Of(
            Of("version"),
            Of("arguments"),
            new LdemFingerprint("LDEM_4", 2_073_600, Of("model")),
            Of("engine"),
            [new InputFile(InputKind.Kernel, "de.bsp", 10, Of("kernel"))],
            Of("povray"),
            [new InputFile(InputKind.Camera, "nav.yaml", 1, Of("input"))]);
    }
}
