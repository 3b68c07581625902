using Msisf.Adapters.Raster.Heights;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Serving;

/// <summary>The elevation models of a server, alone and as one surface. Thread-safe.</summary>
internal sealed class ServedModels : IDisposable
{
    /// <summary>Between the names of several models, as in the meta file.</summary>
    private const char Joint = '+';

    /// <summary>Sets of models that are open at once: each keeps what it has read.</summary>
    private const int MaxSets = 16;

    /// <summary>Seeds of invented detail whose ground is kept: those that were asked for last.</summary>
    private const int MaxRefined = 4;

    private readonly ProgramHost _host;
    private readonly Lock _gate = new();
    private readonly Dictionary<string, ServedModel> _several = [];
    private readonly LinkedList<(ServedModel Model, RefineSettings Detail, ServedModel Refined)> _refined = [];

    /// <summary>Looks for the models, and opens none.</summary>
    /// <param name="ldem">The paths that are given; empty for what a run finds.</param>
    /// <exception cref="BadInputException">There is none, or two have the same name.</exception>
    public ServedModels(IReadOnlyList<string> ldem, ProgramHost host)
    {
        _host = host;
        IReadOnlyList<string> folders = ModelOpening.Folders(host);
        All = [.. SurfaceOptions.Ldem.NamedInErrors(() => ldem.Count == 0 ? Whole(path: null, folders) : ldem.SelectMany(
            path => Map(path) is { } map ? [map] : Whole(path, folders)))
            .OrderByDescending(model => model.Resolution.MetresPerPixel)];
        if (All.Count == 0)
        {
            throw new BadInputException(
                $"No elevation model in {string.Join(", ", ldem.Count > 0 ? ldem : folders)}. Get one with 'msis fetch ldem', or name "
                    + $"one with {SurfaceOptions.Ldem.Name}.");
        }

        if (ldem.Count > 1 && All.GroupBy(model => model.Name, StringComparer.OrdinalIgnoreCase).FirstOrDefault(
            same => same.Count() > 1) is { } twice)
        {
            throw new BadInputException(
                $"Two elevation models are named {twice.Key}; requests could not tell them apart. Leave one of them out.")
                .About(SurfaceOptions.Ldem);
        }

        if (All.FirstOrDefault(model => model.IsWholeMoon) is null)
        {
            throw new BadInputException(
                "None of the elevation models is of the whole Moon. Give one that is as well, for instance LDEM_4.")
                .About(SurfaceOptions.Ldem);
        }
    }

    /// <summary>The models, coarse ones first.</summary>
    public IReadOnlyList<ServedModel> All { get; }

    /// <summary>
    /// The models that make one surface: all maps of a part, in the finest model of the whole Moon that is coarser than them. Empty if
    /// there is no map, or no such model.
    /// </summary>
    public IReadOnlyList<ServedModel> OneSurface
    {
        get
        {
            ServedModel[] maps = [.. All.Where(model => !model.IsWholeMoon)];
            return maps.Length > 0 && All.TakeWhile(model => model != maps[0]).LastOrDefault() is { } around ? [around, .. maps] : [];
        }
    }

    /// <summary>The model of some names: one, or several that make one surface, in any order.</summary>
    /// <param name="names">The names; also several in one with "+" between them.</param>
    public ServedModel Named(IReadOnlyList<string> names)
    {
        ServedModel[] models = [.. names.SelectMany(name => TryOne(name) is { } one ? [one] : name.Split(Joint).Select(One))
            .OrderBy(model => model.Name, StringComparer.Ordinal)];
        if (models.Length == 1)
        {
            return models[0].IsWholeMoon ? models[0] : throw new UsageException(
                $"'model' is {models[0].Name}, a map of a part of the Moon. Name a model of the whole Moon with it: [\"{Around()}\", "
                    + $"\"{models[0].Name}\"].");
        }

        if (models.Length == 0)
        {
            throw new UsageException("'model' is an empty list; the name of a model is needed.");
        }

        if (models.GroupBy(model => model.Name).FirstOrDefault(same => same.Count() > 1) is { } twice)
        {
            throw new UsageException($"'model' has {twice.Key} twice. Leave one of them out.");
        }

        return Several(models);
    }

    /// <summary>A model with invented detail; frames that are drawn from it may go on when it is no longer kept.</summary>
    /// <param name="model">One of these models, alone or as one surface.</param>
    /// <param name="detail">What is invented.</param>
    public ServedModel Refined(ServedModel model, RefineSettings detail)
    {
        lock (_gate)
        {
            var known = _refined.FirstOrDefault(kept => kept.Model == model && kept.Detail == detail);
            if (known.Refined is not null)
            {
                _refined.Remove(known);
            }
            else
            {
                known = (model, detail, model.With(detail, _host));
            }

            _refined.AddFirst(known);
            if (_refined.Count > MaxRefined)
            {
                _refined.RemoveLast();
            }

            return known.Refined;
        }
    }

    public void Dispose()
    {
        foreach (ServedModel model in All.Concat(_several.Values))
        {
            model.Dispose();
        }
    }

    private ServedModel Several(IReadOnlyList<ServedModel> models)
    {
        string name = string.Join(Joint, models.Select(model => model.Name));
        lock (_gate)
        {
            if (!_several.TryGetValue(name, out ServedModel? several))
            {
                if (_several.Count == MaxSets)
                {
                    throw new UsageException(
                        $"the server draws {MaxSets} sets of several models already, and keeps no more open. Ask for one of them.");
                }

                _several[name] = several = ServedModel.Of(models, name, _host);
            }

            return several;
        }
    }

    private string Around() => All.Last(model => model.IsWholeMoon).Name;

    private ServedModel One(string name) => TryOne(name) ?? throw ServedNames.Unknown("model", name, All.Select(model => model.Name));

    private ServedModel? TryOne(string name) => All.FirstOrDefault(model => model.Name.Equals(name, StringComparison.OrdinalIgnoreCase));

    private IEnumerable<ServedModel> Whole(string? path, IReadOnlyList<string> folders) =>
        LdemCatalog.All(path, folders).Select(set => new ServedModel(
            set.ProductId, set.PixelsPerDegree, set.IsSynthetic, set.IsWholeMoon || path is null, set.Parts[0].LabelPath, path, _host));

    private ServedModel? Map(string path)
    {
        ModelPath model = ModelPath.Parse(path);
        if (RasterFiles.IsForGdal(model.Path))
        {
            return new ServedModel(
                RasterFiles.ProductIdOf(model.Path), _host.GeoTiffs.ResolutionOf(model.Path, model.Heights), isSynthetic: false,
                _host.GeoTiffs.CoversWholeMoon(model.Path, model.Heights), model.Path, path, _host);
        }

        return LdemCatalog.TryReadMap(model.Path) is { Polar: { } polar } label
            ? new ServedModel(label.ProductId, polar.Resolution, label.IsSynthetic, isWholeMoon: false, model.Path, path, _host)
            : null;
    }
}
