using Msisf.App.Host;
using Msisf.App.Series;
using Msisf.App.Settings;
using Msisf.Adapters.Manifest;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.App.Tests.Series;

public sealed class SeriesMergeTests : IDisposable
{
    private readonly SeriesFolder _folder = new();
    private readonly StringWriter _results = new();

    public void Dispose()
    {
        _folder.Dispose();
        _results.Dispose();
    }

    [Fact]
    public async Task Run_FramesInAnyOrder_ManifestIsInTheOrderOfSteps_AndSaysTheSame()
    {
        _folder.Make(SeriesFolder.Plan("--fov 40", "a", "b", "c"), 3, 1, 2);
        string[] before = [.. File.ReadAllLines(_folder[ManifestFile.Name]).Order(StringComparer.Ordinal)];

        SeriesStatus status = await RunAsync(new MergeSettings(ContactSheet: false, FrameRate: null));

        string[] after = File.ReadAllLines(_folder[ManifestFile.Name]);
        Assert.True(status.IsComplete);
        Assert.Equal([1, 2, 3], _folder.Manifest.Frames.Values.Select(frame => frame.Step));
        Assert.Equal(before, after.Order(StringComparer.Ordinal));
        Assert.Equal($"{_folder[ManifestFile.Name]}{Environment.NewLine}", _results.ToString());
    }

    [Fact]
    public async Task Run_VideoWithoutFfmpeg_SaysHowToGetIt()
    {
        _folder.Make(SeriesFolder.Plan("--fov 40", "a"), 1);

        ExternalPartException error = await Assert.ThrowsAsync<ExternalPartException>(
            () => RunAsync(new MergeSettings(ContactSheet: false, FrameRate: 30.0)));

        Assert.StartsWith("no ffmpeg on the PATH: no video is made.", error.Message, StringComparison.Ordinal);
        Assert.Empty(Directory.GetDirectories(_folder.Path)); // no folder of unfinished work stays
        Assert.False(File.Exists(_folder[SeriesMerge.VideoName]));
    }

    private Task<SeriesStatus> RunAsync(MergeSettings settings) => SeriesMerge.RunAsync(
        _folder.Path,
        settings,
        new ProgramHost(TimeProvider.System, static _ => null)
        {
            Results = _results,
            Log = _folder.Log,
            Progress = new NoProgress(),
            StandardInput = () => TextReader.Null,
        },
        CancellationToken.None);
}
