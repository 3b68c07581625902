using Msisf.Core.Mesh;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Visibility;

/// <summary>A facet that some pixel shows or showed for a while.</summary>
/// <param name="Normal">Outward, MOON_ME, m2: twice the facet's area long.</param>
/// <param name="Offset">m3: product of the normal with each point of the facet, from <see cref="ImageView.Anchor"/>.</param>
/// <param name="Line">Its cell's line.</param>
/// <param name="SampleAndHalf">Twice its cell's sample, plus 1 for the north-eastern half.</param>
internal readonly record struct FacetRecord(Vector3D Normal, double Offset, int Line, int SampleAndHalf)
{
    /// <summary>The facet's name.</summary>
    public FacetId Facet => new(Line, SampleAndHalf >> 1, (SampleAndHalf & 1) == 0 ? FacetHalf.SouthWest : FacetHalf.NorthEast);
}
