using Msisf.App.Settings.Specs;
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

    /// <summary>The settings; null without invented detail.</summary>
    /// <exception cref="UsageException">They are wrong, or do not go with others.</exception>
    public static RefineSettings? Read(OptionValues values)
    {
        double cell = NativeOptions.RefineCell.Read(values);
        if (NativeOptions.Refine.ReadIfGiven(values) is not { } text || ChoiceSpec.IsSame(text, NativeOptions.NoDetail))
        {
            return values.Text(NativeOptions.RefineCell) is null
                ? null
                : throw NativeOptions.RefineCell.Wrong(
                    "is given, but no --refine. Give that with a seed, or leave it out.", NativeOptions.Refine);
        }

        // The command that a frame's meta file holds names the default.
        if (SurfaceOptions.LevelOfDetailError.ReadIfGiven(values) is { } error && error != DetailRule.DefaultError)
        {
            throw SurfaceOptions.LevelOfDetailError.Wrong(
                "is for levels of detail of one model; with --refine the ground is drawn from the model itself. Leave one of them out.",
                NativeOptions.Refine);
        }

        return ulong.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out ulong seed)
            ? new RefineSettings(seed, (int)Math.Floor(Math.Log2(cell)))
            : throw NativeOptions.Refine.Wrong(
                $"is '{text}'; a whole number from 0 to {ulong.MaxValue}, or {NativeOptions.NoDetail}, is needed.");
    }
}
