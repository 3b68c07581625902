namespace Msisf.Core.Layers;

/// <summary>The layers that a user wants. Immutable.</summary>
public sealed class LayerSet
{
    /// <summary>The word for every layer.</summary>
    public const string AllText = "all";

    private LayerSet(IReadOnlyList<Layer> layers) => Layers = layers;

    /// <summary>Every layer.</summary>
    public static LayerSet All { get; } = new(LayerCatalogue.All);

    /// <summary>Every layer that frames of one elevation model, without detector and without catalogue, have.</summary>
    public static LayerSet OfAnyFrame { get; } =
        new([.. LayerCatalogue.All.Where(layer => !layer.NeedsDetector && !layer.NeedsCraters && !layer.NeedsSky && !layer.NeedsModels
            && !layer.NeedsInventedGround && !layer.NeedsIndirect)]);

    /// <summary>For messages and help: the names that <see cref="Parse"/> knows.</summary>
    public static string ValidValues => $"{AllText}, or a list of {string.Join(", ", LayerCatalogue.All.Select(layer => layer.Name))}";

    /// <summary>In the order of <see cref="LayerCatalogue.All"/>, each once; at least one.</summary>
    public IReadOnlyList<Layer> Layers { get; }

    /// <summary>Layers that are not in the catalogue.</summary>
    internal static LayerSet Of(IReadOnlyList<Layer> layers) => new(layers);

    /// <summary>Reads the value of <c>--layers</c>.</summary>
    /// <param name="text">"all", or names with commas between; order, capitals and blanks around names don't matter.</param>
    /// <exception cref="UsageException">A name is unknown, empty or given twice.</exception>
    public static LayerSet Parse(string text)
    {
        string[] names = text.Split(',', StringSplitOptions.TrimEntries);
        if (names is [var only] && IsSame(only, AllText))
        {
            return All;
        }

        HashSet<Layer> wanted = [];
        foreach (string name in names)
        {
            Layer layer = LayerCatalogue.All.FirstOrDefault(layer => IsSame(layer.Name, name))
                ?? throw new UsageException($"--layers {text}: '{name}' is not a layer. Give {ValidValues}.");
            if (!wanted.Add(layer))
            {
                throw new UsageException($"--layers {text}: {layer.Name} is there twice. Leave one out.");
            }
        }

        return new LayerSet([.. LayerCatalogue.All.Where(wanted.Contains)]);
    }

    /// <summary>These layers without some.</summary>
    /// <param name="isLeftOut">Which; not all.</param>
    public LayerSet Without(Func<Layer, bool> isLeftOut) => new([.. Layers.Where(layer => !isLeftOut(layer))]);

    /// <summary>The same layers for a scene of several elevation models, whose cells have a model as well.</summary>
    public LayerSet OfSeveralModels() =>
        new([.. Layers.Select(layer => layer.Name == LayerCatalogue.CellOfSeveral.Name ? LayerCatalogue.CellOfSeveral : layer)]);

    private static bool IsSame(string a, string b) => a.Equals(b, StringComparison.OrdinalIgnoreCase);
}
