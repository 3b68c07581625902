using Msisf.Adapters.IO;
using Msisf.Adapters.Input;
using Msisf.Adapters.Manifest;
using Msisf.Adapters.Navigation;
using Msisf.App.Cluster;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Products;
using Msisf.App.Rendering;
using Msisf.App.Series;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Camera;
using Msisf.Core.Scene;
using Msisf.Core.Time;
using System.Security.Cryptography;
using System.Text;

namespace Msisf.App.DataSets;

/// <summary>
/// Makes a data set: draws its states into a batch file, runs that as any other, and writes index and card when all images are there.
/// </summary>
internal sealed class DataSetRun
{
    /// <summary>Name of the batch file with the states.</summary>
    public const string StatesName = "states.csv";

    private readonly DataSetSpec _spec;
    private readonly RenderSettings _settings;
    private readonly ProgramHost _host;

    private DataSetRun(DataSetSpec spec, RenderSettings settings, ProgramHost host) => (_spec, _settings, _host) = (spec, settings, host);

    private string Folder => _settings.OutputFolder;

    /// <summary>Makes a data set, here or on Slurm.</summary>
    /// <param name="path">The data set's file.</param>
    /// <param name="words">Words of the call, for the head of a script.</param>
    /// <param name="cancellation">Cancels the work; finished images are kept.</param>
    /// <returns>The exit code.</returns>
    /// <exception cref="MsisfException">It can't be made, or an image failed; then the others are complete.</exception>
    public static async Task<int> RunAsync(
        string path, OptionValues line, IReadOnlyList<string> words, ProgramHost host, CancellationToken cancellation)
    {
        bool isOnSlurm = DataSetOptions.ReadIsOnSlurm(line);
        DataSetSpec spec = DataSetFile.Read(path, line, host);
        DataSetRun run = new(spec, RigOptions.ReadOne(spec.Options, host.GeoTiffs, "a data set is of one"), host);
        run.RefuseUseless();
        ResourceCheck.Check([(run._settings, 1)], 1, GC.GetGCMemoryInfo().TotalAvailableMemoryBytes, long.MaxValue);
        DrawnStates drawn = run.Draw(cancellation);
        FolderBefore before = FolderBefore.Of(run.Folder);
        try
        {
            return await run.MakeAsync(drawn, isOnSlurm, words, cancellation).ConfigureAwait(false);
        }
        catch (MsisfException)
        {
            before.RestoreIfUnused();
            throw;
        }
    }

    private async Task<int> MakeAsync(DrawnStates drawn, bool isOnSlurm, IReadOnlyList<string> words, CancellationToken cancellation)
    {
        string states = WriteStates(drawn);
        OptionValues values = _spec.Options.With([KeyValuePair.Create(CameraOptions.BatchFile.Name, new OptionValue([states]))]);
        if (isOnSlurm)
        {
            RunSubmission submission = await RunSubmission.SubmitAsync(values, words, _host, cancellation).ConfigureAwait(false);
            if (!ScriptOptions.Wait.Read(values))
            {
                _host.Log.Note(
                    "When the jobs have ended, the same call without --pieces writes index and card, and makes what is missing.");
                return 0;
            }

            int code = await submission.FollowAsync(cancellation).ConfigureAwait(false);
            if (code != 0)
            {
                _host.Log.Error($"images are missing after all retries: the logs in {submission.Run.Script}.logs say why.");
                return code;
            }
        }
        else
        {
            await RenderRun.RunAsync(TrajectorySettingsReader.Read(values), [_settings], _host, cancellation).ConfigureAwait(false);
        }

        Finish(drawn, cancellation);
        return 0;
    }

    private void RefuseUseless()
    {
        if (_settings.IgnoreSun && (_spec.Distributions.ContainsKey(Quantity.SunElevation) || _spec.Accept.SunElevation is not null))
        {
            throw new UsageException($"{_spec.Path}: 'sun-elevation' has no meaning with {LightOptions.IgnoreSun.Name}. Leave one out.")
                .About(LightOptions.IgnoreSun);
        }

        if (_spec.Indexes.Contains("coco") && _settings.Native.Navigation?.Craters is null)
        {
            throw new BadInputException(
                $"{_spec.Path}: the index 'coco' holds craters, and no option names a catalogue. Add one below 'options', e.g. "
                    + "'craters: craters.csv', or leave 'coco' out of 'index'.");
        }
    }

    private DrawnStates Draw(CancellationToken cancellation)
    {
        using EphemerisSource ephemeris = new(_settings, _host);
        using ModelOnDemand model = new(_settings, _host, cancellation);
        using SurfaceInputs maps = SurfaceInputs.Open(_settings, _host);
        _ = NavigationInputs.Open(_settings.Native.Navigation, model.Opened.Grid.ReferenceRadius); // a wrong list is found now
        DataSetSource.RequireLicences(_spec, _settings, model.Opened, maps);
        RunGeometry geometry = new(() => model.Opened, ephemeris.Engine, ephemeris.TimeScale, _settings.Aberration, _settings.Body);
        ViewProbe probe = new(_settings, model.Opened, maps, _host.Times);
        using IRunProgress progress = _host.Progress.Start("States", _spec.Splits.Sum(split => split.Count), _settings.Unattended);
        DrawnStates drawn = new StateDraw(_spec, _settings, geometry, ephemeris.Engine, probe).Run(progress, cancellation);
        foreach (SplitDraw draw in drawn.Splits)
        {
            _host.Log.Note(Invariant($"{draw.Split.Name}: {draw.Split.Count} of {draw.Candidates} states meet the conditions."));
        }

        return drawn;
    }

    /// <summary>Writes the states, unless they are there; those of another data set are not replaced, those of fewer images are.</summary>
    private string WriteStates(DrawnStates drawn)
    {
        string path = Path.Combine(Folder, StatesName);
        using StringWriter text = new() { NewLine = "\n" };
        BatchFileWriter.Write(
            text, $"states of the data set {_spec.Name}, msis {_host.Version}", [.. drawn.States.Select(state => state.State)]);
        string content = text.ToString();
        if (File.Exists(path) && !_settings.Overwrite)
        {
            string known = FileErrors.ToBadInput($"{path}: can't be read", () => File.ReadAllText(path));
            if (known.Length > content.Length && known.StartsWith(content, StringComparison.Ordinal))
            {
                throw new UsageException(Invariant(
                    $"{Folder}: more images of this data set are there than 'count' says. Set 'count' to at least "
                        + $"{_spec.Order.Count + ((known[content.Length..].Count(letter => letter == '\n')) / (_spec.HasPairs ? 2 : 1))}, "
                        + $"or use another --output-dir.")).About(OutputOptions.Folder);
            }

            // A data set of more images begins with those that are there.
            if (!content.StartsWith(known, StringComparison.Ordinal))
            {
                throw new UsageException(
                    $"{Folder}: another data set, or another state of this one, is there: {StatesName} differs. Use --overwrite to "
                        + "replace it, or another --output-dir.").About(OutputOptions.Folder);
            }
        }

        OutputOptions.Folder.NamedInErrors(() => FileErrors.ToExternalPart(
            $"--output-dir {Folder}: the folder can't be made", () => Directory.CreateDirectory(Folder)));
        AtomicFile.Write(path, stream => stream.Write(Encoding.UTF8.GetBytes(content)));
        return path;
    }

    /// <summary>Writes index and card if all images are there.</summary>
    private void Finish(DrawnStates drawn, CancellationToken cancellation)
    {
        ManifestFile manifest = SeriesManifest.Find(Folder);
        ManifestContent content = SeriesManifest.Read(manifest, _host.Log);
        int there = SeriesStatus.Of(Folder, content, new FrameChecker(Folder, CheckDepth.Lengths), cancellation)
            .CountOf(FrameState.Complete);
        if (there < drawn.States.Count)
        {
            _host.Log.Note(Invariant($"{there} of {drawn.States.Count} images are there; index and card are written when all are."));
            return;
        }

        FrameRecord[] frames = [.. content.Expected.Values.Where(expected => expected.Run == content.LastRun)
            .OrderBy(expected => expected.Step).Select(expected => content.Frames[expected.Name])];
        DataSetImage[] images = [.. frames.Select((frame, index) => new DataSetImage(frame.Step, drawn.States[index], frame.Files))];
        using AtomicFileSet files = new();
        string states = Path.Combine(Folder, StatesName);
        List<string> paths = [Path.Combine(Folder, DataSetIndex.CsvName)];
        DataSetIndex index = new(images, _settings.CameraModel, CocoSourceOf(content.Settings[frames[0].Settings].Description));
        files.WriteText(paths[0], index.WriteCsv);
        foreach (Split split in _spec.Splits)
        {
            paths.AddRange(_spec.Indexes.SelectMany(format => index.Write(files, Folder, split.Name, format)));
        }

        List<OutputFile> shared = [FileOf(states, (new FileInfo(states).Length, FileHash.Sha256Of(states, cancellation)))];
        shared.AddRange(paths.Select(path => FileOf(path, files.Measure(path))));
        DataSetCard card = CardOf(drawn, content, frames, shared);
        string[] cards = [.. new[] { DataSetCard.MarkdownName, DataSetCard.JsonName, DataSetCard.PlotsName }
            .Select(name => Path.Combine(Folder, name))];
        files.WriteText(cards[0], card.WriteMarkdown);
        files.Write(cards[1], card.WriteJson);
        files.WriteText(cards[2], writer => HistogramPlots.Write(writer, card.Histograms));
        shared.AddRange(cards.Select(path => FileOf(path, files.Measure(path))));
        manifest.Append(
            shared.Where(file => content.Shared.GetValueOrDefault(file.Name) != file).Select(file => new SharedFileRecord(file)));
        files.Commit();
        foreach (string path in paths.Concat(cards))
        {
            _host.Results.WriteLine(path);
        }
    }

    private CocoSource CocoSourceOf(string description)
    {
        IEnumerable<string> ofSources = DataSetSource.Of(_spec, description).Select(source => $"{source.Name}: {source.Licence}");
        return new CocoSource(_spec.Description ?? _spec.Name, _host.Version, [_spec.Licence ?? CocoSource.NoLicence, .. ofSources]);
    }

    private DataSetCard CardOf(DrawnStates drawn, ManifestContent content, FrameRecord[] frames, IReadOnlyList<OutputFile> files)
    {
        SettingsRecord settings = content.Settings[frames[0].Settings];
        SpacecraftState first = drawn.States[0].State;
        CameraMatrix matrix = CameraMatrix.Of(_settings.CameraModel.At(new CameraState(first.PositionBodyFixed, first.MoonFromCamera)));
        string all = string.Concat(frames.SelectMany(frame => frame.Files).Select(file => $"{file.Name} {file.Sha256}\n"));
        return new DataSetCard
        {
            Spec = _spec,
            Drawn = drawn,
            Histograms = Histogram.Of(_spec, [.. drawn.States.Where((_, index) => !_spec.HasPairs || index % 2 == 0)]),
            Arguments = DataSetSource.ArgumentsOf(settings.Description),
            Version = _host.Version,
            Camera = (matrix.Width, matrix.Height, [.. matrix.IntrinsicRows.Select(row => (double[])[row.X, row.Y, row.Z])]),
            Sources = DataSetSource.Of(_spec, settings.Description),
            Files = files,
            Content = Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(all))),
        };
    }

    private static OutputFile FileOf(string path, (long Bytes, string Sha256) measured) =>
        new(Path.GetFileName(path), measured.Bytes, measured.Sha256);
}
