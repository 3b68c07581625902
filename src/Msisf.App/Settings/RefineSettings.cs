using Msisf.App.Settings.Specs;
using Msisf.Core.Layers;
using Msisf.Core.Lod;
using Msisf.Core.Surface.Sources;

namespace Msisf.App.Settings;

/// <summary>Invented detail below the elevation models.</summary>
/// <param name="FinestLevel">The narrowest cells are 2^this m wide.</param>
internal sealed record RefineSettings(ulong Seed, int FinestLevel)
{
    /// <summary>m: narrower cells than a camera some metres over the ground needs would show nothing but noise.</summary>
    public const double DefaultCell = 0.0625;

    /// <summary>m: see <see cref="RefinedTerrain.LeastLevel"/>.</summary>
    public const double NarrowestCell = 0.03125;

    /// <summary>m: about half a cell of a model with 16 samples a degree.</summary>
    public const double WidestCell = 1024.0;

    /// <summary>m: width of the narrowest cells.</summary>
    public double Cell => Math.ScaleB(1.0, FinestLevel);

    /// <summary>The layers that a frame has with or without invented detail.</summary>
    /// <param name="layers">The layers that are asked for; null for none.</param>
    /// <param name="settings">The invented detail, if there is any.</param>
    /// <exception cref="UsageException">One of them needs invented detail.</exception>
    public static LayerSet? LayersOf(LayerSet? layers, bool isAll, RefineSettings? settings)
    {
        if (layers is null || settings is not null)
        {
            return layers;
        }

        return isAll || layers.Layers.FirstOrDefault(layer => layer.NeedsInventedGround) is not { } layer
            ? layers.Without(layer => layer.NeedsInventedGround)
            : throw new UsageException(
                $"--layers: {layer.Name} needs invented ground. Give {NativeOptions.Refine.Name} with a seed, or leave the layer out.")
                .About(NativeOptions.Layers, NativeOptions.Refine);
    }

    /// <summary>The settings; null without invented detail.</summary>
    /// <exception cref="UsageException">They are wrong, or do not go with others.</exception>
    public static RefineSettings? Read(OptionValues values)
    {
        double cell = NativeOptions.RefineCell.Read(values);
        if (NativeOptions.Refine.ReadIfGiven(values) is not { } text)
        {
            return values.Text(NativeOptions.RefineCell) is null
                ? null
                : throw new UsageException("--refine-cell is given, but no --refine. Give that with a seed, or leave it out.")
                    .About(NativeOptions.RefineCell, NativeOptions.Refine);
        }

        // The command that a frame's meta file holds names the default.
        if (SurfaceOptions.LevelOfDetailError.ReadIfGiven(values) is { } error && error != DetailRule.DefaultErrorOfImage)
        {
            throw new UsageException(
                "--lod-error is for levels of detail of one model; with --refine the ground is drawn from the model itself. "
                    + "Leave one of them out.").About(SurfaceOptions.LevelOfDetailError, NativeOptions.Refine);
        }

        return ulong.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out ulong seed)
            ? new RefineSettings(seed, (int)Math.Floor(Math.Log2(cell)))
            : throw new UsageException(
                $"{NativeOptions.Refine.Name} is '{text}'; a whole number from 0 to {ulong.MaxValue} is needed.")
                .About(NativeOptions.Refine);
    }
}
