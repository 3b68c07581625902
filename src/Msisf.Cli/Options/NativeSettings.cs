using Msisf.Core.Layers;
using Msisf.Core.Render;
using Msisf.Core.Render.Photometry;

namespace Msisf.Cli.Options;

/// <summary>The checked options of the program's own renderer.</summary>
internal sealed record NativeSettings
{
    public required NativeRenderOptions Render { get; init; }

    public required GreyScale Grey { get; init; }

    public required int BitDepth { get; init; }

    /// <summary>Ground truth to write; null for none.</summary>
    public required LayerSet? Layers { get; init; }

    public required LayersFormat LayersFormat { get; init; }
}
