using System.Security.Cryptography;
using System.Text;
using Msisf.Adapters.Catalogues;
using Msisf.Adapters.Illumination;
using Msisf.Adapters.Maps;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Ephemeris;
using Msisf.Core.Illumination;
using Msisf.Core.Maps;
using Msisf.Core.Navigation;
using Msisf.Core.Time;

namespace Msisf.App.Illumination;

/// <summary>Makes maps and tables of light (docs/illumination.md).</summary>
internal sealed class IlluminationRun
{
    /// <summary>Cells of a piece, whose horizons are held in memory and kept in one file of some 40 MB.</summary>
    private const int PieceCells = 16_384;

    private const int EarthNumber = 399;

    private readonly IlluminationSettings _settings;
    private readonly ElevationModel _model;
    private readonly IEphemeris _engine;
    private readonly Instant[] _times;
    private readonly Aberration _aberration;
    private readonly CelestialBody _body;
    private readonly string _surface;
    private readonly ProgramHost _host;
    private readonly RunInputs _inputs;
    private readonly CancellationToken _cancellation;
    private readonly LightConditions _conditions;

    private IlluminationRun(
        IlluminationSettings settings, RenderSettings models, ElevationModel model, IEphemeris engine, RunInputs inputs, ProgramHost host,
        CancellationToken cancellation)
    {
        (_settings, _model, _engine, _inputs, _host, _cancellation) = (settings, model, engine, inputs, host, cancellation);
        _aberration = models.Aberration;
        _body = models.Body;
        _times = [.. settings.Times.Select(engine.TimeScale.InstantOf)];
        _surface = string.Join(' ', models.Ldem.Select(text => text[ModelPath.Parse(text).Path.Length..]));
        _conditions = new LightConditions(
            [.. _times.Select(SunAt)], [.. _times.Select(EarthAt)])
        {
            IsPoint = settings.IsPoint,
            IsExact = settings.IsExact,
            FixedPlane = settings.PlaneNormal ?? Vector3D.UnitZ,
            NightLimit = settings.NightLimit / settings.StepHours,
        };
    }

    /// <summary>Runs the command.</summary>
    /// <param name="settings">What to do.</param>
    /// <param name="models">Names the models and kernels.</param>
    /// <param name="host">Output, log, clock and environment of the program.</param>
    /// <param name="cancellation">Stops the work; what is done is kept.</param>
    /// <exception cref="MsisfException">Something can't be read, written, or is outside the models.</exception>
    public static void Run(IlluminationSettings settings, RenderSettings models, ProgramHost host, CancellationToken cancellation)
    {
        using EphemerisSource ephemeris = new(models, host);
        using ModelOnDemand model = new(models, host, cancellation);
        FileErrors.ToExternalPart($"{settings.Folder}: the folder can't be made", () => Directory.CreateDirectory(settings.Folder));
        using RunInputs inputs = new(ephemeris.KernelFiles, host, cancellation);
        IlluminationRun run = new(settings, models, model.Opened, ephemeris.Engine(), inputs, host, cancellation);
        run.Tell();
        if (settings.Place is not null || settings.Points is null)
        {
            run.MakeMaps();
        }

        if (settings.Points is { } points && settings.Piece == (0, 1))
        {
            run.MakePoints(points);
        }
    }

    private Vector3D SunAt(Instant time) => _engine.SunPositionBodyFixed(time, _aberration);

    private Vector3D EarthAt(Instant time) =>
        _engine.BodyFromJ2000(time.Tdb) * _engine.StateOf(EarthNumber, time.Tdb).Position;

    private void Tell()
    {
        if (_settings.Times.Step > Duration.Day)
        {
            _host.Log.Note("The step of the interval is longer than a day: sunrises and nights in between are not seen.");
        }

        if (!_model.Grid.IsWholeBody)
        {
            _host.Log.Warning(
                "The ground is a part of the Moon only: mountains beyond its border throw no shadows. Give a model of the "
                    + "whole Moon as well.");
        }
    }

    private void MakeMaps()
    {
        MapGrid region = IlluminationRegion.Of(_settings, _model.Grid);
        NasaLightMap[] maps = [.. _settings.Compared.Select(path => IlluminationOptions.Compare.NamedInErrors(
            () => NasaLightMap.Read(path)))];
        int lines = Math.Max(1, PieceCells / region.Samples);
        int pieces = (region.Lines + lines - 1) / lines;
        HorizonSurvey survey = new(_model.Grid, _model.Tracer, region.Spread(), _body.IsMoon);
        LightSurvey lights = new(survey, _conditions);
        List<CellLights> results = [];
        using (IRunProgress progress = _host.Progress.Start(
            "Horizons and light", FractionProgress.Steps, _settings.Unattended))
        {
            FractionProgress fraction = new(progress, "light");
            double all = 2.0 * region.Count * _settings.Heights.Count;
            int done = 0;
            foreach (double height in _settings.Heights)
            {
                PlaceLight[] found = new PlaceLight[region.Count];
                float[] slopes = new float[region.Count];
                for (int piece = _settings.Piece.Part; piece < pieces; piece += _settings.Piece.Parts)
                {
                    int first = piece * lines;
                    Vector3D[] directions = region.DirectionsOf(first, Math.Min(region.Lines, first + lines));
                    PlaceHorizons horizons = HorizonsOf(survey, region, directions, height, piece, Advance);
                    if (_settings.Piece.Parts == 1)
                    {
                        lights.Of(directions, horizons, _settings.Threads, Advance, _cancellation).CopyTo(found, first * region.Samples);
                        horizons.Slopes.CopyTo(slopes, first * region.Samples);
                    }
                }

                results.Add(new CellLights(height, found, slopes));
            }

            void Advance(int places) => fraction.Report(Interlocked.Add(ref done, places) / all);
        }

        if (_settings.Piece.Parts == 1)
        {
            if (!results[0].Ground.Any())
            {
                throw HorizonSurvey.Outside(region.DirectionOf(region.Lines / 2, region.Samples / 2));
            }

            CompareMaps(region, maps, results[0]);
            _inputs.Begin(_model.Sets, []);
            LightMapFiles files = new(
                region, _body, new MapOrigin(_host.Version, _settings.Command, _inputs.All(camera: null)), new MapTimes(
                    $"{_settings.Times[0]}Z", $"{_settings.Times[_settings.Times.Count - 1]}Z", _settings.StepHours,
                    _settings.IsPoint ? "point" : "disc"));
            new IlluminationMaps(_settings, region, files, _host).Write(results);
        }
    }

    private void CompareMaps(MapGrid region, NasaLightMap[] maps, CellLights lights)
    {
        if (maps.Length == 0)
        {
            return;
        }

        NasaComparison comparison = new(region, region.DirectionsOf(0, region.Lines));
        foreach (NasaLightMap map in maps)
        {
            _host.Log.Note(IlluminationOptions.Compare.NamedInErrors(() => comparison.Add(map, lights)));
        }

        string path = Path.Combine(_settings.Folder, "comparison.csv");
        comparison.Write(path);
        _host.Results.WriteLine(path);
        if (_settings.Times.Length / Duration.Day < IlluminationMaps.LongEnough || _settings.Heights[0] != 0.0)
        {
            _host.Log.Note(string.Create(
                CultureInfo.InvariantCulture,
                $"LOLA's maps are of the ground over 18.6 years; these are of {_settings.Heights[0]:R} m over it and "
                    + $"{_settings.Times.Length / Duration.Day:R} days."));
        }
    }

    /// <summary>The horizons of a piece: those that are kept, or new ones.</summary>
    private PlaceHorizons HorizonsOf(
        HorizonSurvey survey, MapGrid region, Vector3D[] directions, double height, int piece, Action<int> advance)
    {
        string content = string.Create(
            CultureInfo.InvariantCulture,
            $"{HorizonSurvey.Version} {_model.Fingerprint().Sha256} {_surface} "
                + $"{region.Projection.Kind} {region.Projection.Latitude:R} {region.Projection.Radius:R} {region.Lines} {region.Samples} "
                + $"{region.CellWidth:R} {region.CellHeight:R} {region.Left:R} {region.Top:R} {height:R}");
        string key = Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(content)))[..16];
        string folder = Path.Combine(_settings.Folder, "horizons");
        FileErrors.ToExternalPart($"{folder}: the folder can't be made", () => Directory.CreateDirectory(folder));
        string path = Path.Combine(folder, string.Create(CultureInfo.InvariantCulture, $"{key}-{piece + 1:D4}.horizons"));
        if (HorizonFile.Read(path, directions.Length) is { } known)
        {
            advance(directions.Length);
            return known;
        }

        PlaceHorizons found = survey.FindWithGaps(directions, height, _settings.Threads, advance, _cancellation);
        HorizonFile.Write(path, found);
        return found;
    }

    private void MakePoints(string list)
    {
        IReadOnlyList<Landmark> points = IlluminationOptions.Points.NamedInErrors(() => ReadPoints(list));
        HorizonSurvey survey = new(_model.Grid, _model.Tracer, points.Select(point => point.Direction), _body.IsMoon) { IsFine = true };
        LightSurvey lights = new(survey, _conditions with { IsExact = true });
        PointTables tables = new(_settings, _times, survey, lights, _model, _conditions, SunAt, _host);
        using IRunProgress progress = _host.Progress.Start("Points", points.Count * _settings.Heights.Count, _settings.Unattended);
        tables.Write(points, progress, _cancellation);
    }

    private IReadOnlyList<Landmark> ReadPoints(string list)
    {
        IReadOnlyList<Landmark> points = LandmarkReader.Read(
            list, _model.Grid.ReferenceRadius, IlluminationOptions.MaxPoints, _settings.Columns);
        if (points.FirstOrDefault(point => point.Height is not null) is { } high)
        {
            throw new BadInputException(
                $"{list}: the point '{high.Identity}' has a height of its own. Points lie on the ground of the models, and "
                    + $"{IlluminationOptions.Heights.Name} gives heights over it, for all points: give lat and lon without a height.");
        }

        IReadOnlyList<string> unused = LandmarkReader.UnusedColumnsOf(list, _settings.Columns);
        if (unused.Count > 0)
        {
            _host.Log.Note($"{list}: columns that are not used: {string.Join(", ", unused)}.");
        }

        return points;
    }
}
