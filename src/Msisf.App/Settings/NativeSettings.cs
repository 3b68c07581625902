using Msisf.Core.Layers;
using Msisf.Core.Render;
using Msisf.Core.Render.Photometry;

namespace Msisf.App.Settings;

/// <summary>The checked options of the program's own renderer.</summary>
internal sealed record NativeSettings
{
    public required NativeRenderOptions Render { get; init; }

    /// <summary>The reflectance law as text: its name, and the parameters that were given in the order of their names.</summary>
    public required string ReflectanceText { get; init; }

    /// <summary>Albedo that was given; null for the law's own.</summary>
    public required double? Albedo { get; init; }

    public required GreyScale Grey { get; init; }

    public required int BitDepth { get; init; }

    /// <summary>Ground truth to write; null for none.</summary>
    public required LayerSet? Layers { get; init; }

    public required LayersFormat LayersFormat { get; init; }
}
