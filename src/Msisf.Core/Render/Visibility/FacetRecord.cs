using Msisf.Core.Mesh;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Visibility;

/// <summary>A facet that is, or was during drawing, the nearest one at some pixel.</summary>
/// <param name="Normal">Outward normal, MOON_ME, m2; its length is twice the facet's area.</param>
/// <param name="Offset">m3: dot product of the normal and any point of the facet, relative to <see cref="ImageView.Anchor"/>.</param>
/// <param name="Line">Line of the facet's cell.</param>
/// <param name="SampleAndHalf">Twice the sample of the facet's cell, plus 1 for the north-eastern half.</param>
internal readonly record struct FacetRecord(Vector3D Normal, double Offset, int Line, int SampleAndHalf)
{
    /// <summary>Identifies the facet in the mesh.</summary>
    public FacetId Facet => new(Line, SampleAndHalf >> 1, (SampleAndHalf & 1) == 0 ? FacetHalf.SouthWest : FacetHalf.NorthEast);
}
