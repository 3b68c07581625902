using Msisf.Adapters.Ephemeris;
using Msisf.App.Settings.Specs;
using Msisf.Core.Metadata;
using Msisf.Core.Render;
using Msisf.Core.Render.Photometry;

namespace Msisf.App.Settings;

/// <summary>The role of an option that decides bytes of the outputs, so that another value makes another frame.</summary>
internal sealed class DecidesBytes : OptionRole
{
    /// <summary>The state of the frame stands for the option.</summary>
    public static readonly DecidesBytes ByStates = new() { IsOfRequests = true };

    /// <summary>The states of a run's frames stand for the option, which says nothing about a single one.</summary>
    public static readonly DecidesBytes ByStatesOfRun = new();

    /// <summary>The checksums of files, or the version of a program, stand for the option.</summary>
    public static readonly DecidesBytes ByFiles = new();

    /// <summary>Canonical arguments of other options stand for the option.</summary>
    public static readonly DecidesBytes ByOthers = new() { IsOfRequests = true };

    /// <summary>The option decides bytes of patterns, models or videos; frames do not know it.</summary>
    public static readonly DecidesBytes OfNoFrame = new();

    private DecidesBytes()
    {
    }

    private DecidesBytes(DecidesBytes other) =>
        (Value, LeavesOutDefault, IsOfRequests, DecidesTiles) =
            (other.Value, other.LeavesOutDefault, other.IsOfRequests, other.DecidesTiles);

    /// <summary>Whether a request to the server may have the option.</summary>
    public bool IsOfRequests { get; private init; }

    /// <summary>Whether the option decides which tiles of the surface a frame needs, and so the patterns of a run.</summary>
    public bool DecidesTiles { get; private init; }

    /// <summary>The option's value among the canonical arguments of a frame; null where it stands for nothing.</summary>
    public Func<FrameContent, object?> Value { get; private init; } = _ => null;

    /// <summary>Whether the default is left out, because frames of older versions have it without saying so.</summary>
    public bool LeavesOutDefault { get; private init; }

    /// <summary>The option is one of the canonical arguments.</summary>
    /// <param name="value">Its value; null where the option has no meaning.</param>
    public static DecidesBytes As(Func<FrameContent, object?> value) => new() { Value = value, IsOfRequests = true };

    /// <summary>The option is one of the canonical arguments if it has another value than its default; for a new option.</summary>
    /// <inheritdoc cref="As"/>
    public static DecidesBytes UnlessDefault(Func<FrameContent, object?> value) => new(As(value)) { LeavesOutDefault = true };

    /// <summary>The same role of an option that requests may not have: it names a file, or is of use for runs only.</summary>
    public DecidesBytes OfRuns() => new(this) { IsOfRequests = false };

    /// <summary>The same role of an option that decides which tiles a frame needs too.</summary>
    public DecidesBytes AndTiles() => new(this) { DecidesTiles = true };
}

/// <summary>What decides the bytes of frames, except their states.</summary>
/// <param name="Settings">Settings of the run.</param>
/// <param name="Engine">The ephemeris engine for the Sun's position; null if none is used.</param>
/// <param name="Map">The map of the Moon's reflectance; null if none is used.</param>
internal sealed record FrameContent(RenderSettings Settings, EphemerisChoice? Engine, InputFile? Map)
{
    /// <summary>Settings of the program's own renderer; null with POV-Ray.</summary>
    public NativeSettings? Native => Settings.Renderer == RendererKind.Native ? Settings.Native : null;

    /// <summary>The same; null without layers too.</summary>
    public NativeSettings? WithLayers => Native?.Layers is null ? null : Native;

    /// <summary>Settings of craters; null without a catalogue.</summary>
    public NavigationSettings? WithCraters => Native?.Navigation is { Craters: not null } navigation ? navigation : null;

    /// <summary>Whether an installed map would be used if no option said that there is none.</summary>
    public bool MayHaveMap => Native?.ReflectanceText == ReflectanceFactory.DefaultLaw;

    /// <summary>Whether the map, the law or the radiance depends on the band.</summary>
    public bool HasBand => Map is not null || MayHaveMap || WithLayers?.Layers!.Layers.Any(layer => layer.Name == "radiance") == true;

    /// <summary>Several models are named, in any order; null for one, whose resolution is enough, unless it has options.</summary>
    public IEnumerable<string>? NamesOfSeveralModels => Settings.Ldem.Count > 1 || Settings.Ldem.Any(ModelPath.HasOptions)
        ? Settings.Ldem.Select(path => Path.GetFileName(path)).Order(StringComparer.Ordinal)
        : null;
}
