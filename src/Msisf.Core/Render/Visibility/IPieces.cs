using Msisf.Core.Camera;

namespace Msisf.Core.Render.Visibility;

/// <summary>What is known of pieces of facets before their points are looked at.</summary>
internal interface IPieces
{
    /// <summary>Whether one point of a facet stands for all of a piece of the image, in the light on it and in its reflectance.</summary>
    /// <param name="inverseDepth">Inverse depth of the piece's middle, 1/m.</param>
    /// <param name="piece">The piece, by the factors of <see cref="FacetPoints.Across"/> and <see cref="FacetPoints.Along"/>.</param>
    bool IsEven(in FacetRecord facet, double inverseDepth, in TangentBox piece);
}
