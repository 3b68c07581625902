using Msisf.Core.Tiles;

namespace Msisf.Adapters.Tiles;

/// <summary>A pattern of a tile or part of one.</summary>
/// <param name="path">Its file.</param>
/// <param name="layout">What its mesh joins.</param>
/// <param name="builder">Makes the mesh.</param>
/// <param name="productId">The elevation model.</param>
/// <param name="format">The form of the mesh.</param>
internal sealed class TilePatternOrder(
    string path, TileMeshLayout layout, TileMeshBuilder builder, string productId, PatternFormat format) : PatternOrder(path)
{
    public override Content Read()
    {
        double[] radii = builder.ReadRadii(layout);
        byte[] header = PatternHeader.WithoutLength(layout, radii, builder.SkirtFootRadius, productId, format);
        return new Content(Path, header, () =>
        {
            TileMesh mesh = builder.Build(layout, radii);
            return stream => PatternWriter.Write(stream, mesh, header, format);
        });
    }
}
