using Msisf.App.Series;
using Msisf.App.Settings;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.App.Tests.Series;

public sealed class ReplacedFramesTests : IDisposable
{
    private readonly SeriesFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Refuse_FinishedFramesOfASeries_AreNamedWithWhatDiffers()
    {
        _folder.Make(SeriesFolder.Plan("--fov 40 --width 64", "a", "b", "c"), 1, 2);
        RunPlan plan = SeriesFolder.Plan("--fov 30 --width 64", "a", "b", "c");

        UsageException error = Assert.Throws<UsageException>(
            () => ReplacedFrames.Refuse(_folder.Path, plan, _folder.Manifest, _folder.Log));

        Assert.Equal(
            $"{_folder.Path}: finished frames would be replaced: 2 frames made with --fov 40, now 30. "
                + "Use --overwrite to replace them, or another --output-dir to keep them.",
            error.Message);
        Assert.Equal([OutputOptions.Folder.Name], error.Options);
        Assert.Empty(_folder.Log.Lines);
    }

    [Fact]
    public void Refuse_SingleImage_IsReplacedWithANote()
    {
        _folder.Make(SeriesFolder.Plan("--fov 40", "a"), 1);

        ReplacedFrames.Refuse(_folder.Path, SeriesFolder.Plan("--fov 30", "a"), _folder.Manifest, _folder.Log);

        Assert.Equal(
            ["Replaced: 1 frame made with --fov 40, now 30. To keep both, use another --output-name or --output-dir."], _folder.Log.Lines);
    }

    /// <summary>The same frames, frames of other names, and frames whose files are gone.</summary>
    [Theory]
    [InlineData("--fov 40", "a", false)]
    [InlineData("--fov 30", "x", false)]
    [InlineData("--fov 30", "a", true)]
    public void Refuse_NothingWouldBeReplaced_IsQuiet(string arguments, string name, bool isGone)
    {
        _folder.Make(SeriesFolder.Plan("--fov 40", "a", "b"), 1, 2);
        if (isGone)
        {
            File.Delete(_folder["a.png"]);
        }

        ReplacedFrames.Refuse(_folder.Path, SeriesFolder.Plan(arguments, name), _folder.Manifest, _folder.Log);

        Assert.Empty(_folder.Log.Lines);
    }

    [Fact]
    public void RefuseUnrecorded_FilesOfNoRun_NamesThreeAndCountsTheOthers()
    {
        _folder.Make(SeriesFolder.Plan("--fov 40", "z"), 1);
        foreach (string name in new[] { "a.png", "a.xml", "b.png", "b.xml", "b.annotated.png", "notes.txt", "c.png" })
        {
            _folder.Write(name, "mine");
        }

        UsageException error = Assert.Throws<UsageException>(
            () => ReplacedFrames.RefuseUnrecorded(_folder.Path, SeriesFolder.Plan("--fov 30", "a", "b"), _folder.Manifest));

        Assert.StartsWith(
            $"{_folder.Path}: files would be replaced that no run has recorded there: a.png, a.xml, b.annotated.png and 2 more.",
            error.Message,
            StringComparison.Ordinal);
        ReplacedFrames.RefuseUnrecorded(_folder.Path, SeriesFolder.Plan("--fov 30", "z", "y"), _folder.Manifest);
    }
}
