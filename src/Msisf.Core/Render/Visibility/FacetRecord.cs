using Msisf.Core.Surface;

namespace Msisf.Core.Render.Visibility;

/// <summary>A facet that is, or was during drawing, the nearest one at some pixel.</summary>
/// <param name="Normal">Outward normal, body-fixed, m2; its length is twice the facet's area.</param>
/// <param name="Offset">m3: dot product of the normal and any point of the facet, relative to <see cref="ImageView.Anchor"/>.</param>
/// <param name="Line">Line of the facet's cell.</param>
/// <param name="PartSampleAndHalf">Model, sample of the facet's cell, and half (<see cref="Place"/>).</param>
internal readonly record struct FacetRecord(Vector3D Normal, double Offset, int Line, int PartSampleAndHalf)
{
    /// <summary>Samples, and facets of seams (<see cref="SeamPatch.MaxFacets"/>), are below 2^23.</summary>
    private const int PartShift = 24;

    private const int SampleMask = (1 << (PartShift - 1)) - 1;

    /// <summary>Identifies the facet in the surface.</summary>
    public FacetId Facet => new(
        Line, (PartSampleAndHalf >> 1) & SampleMask, (PartSampleAndHalf & 1) == 0 ? FacetHalf.SouthWest : FacetHalf.NorthEast)
    {
        Part = PartSampleAndHalf >> PartShift,
    };

    /// <summary>Packs the model, the sample and the half into one number.</summary>
    /// <param name="sample">Sample of the facet's cell.</param>
    /// <param name="half">0: the south-western facet, 1: the north-eastern one.</param>
    public static int Place(int part, int sample, int half) => (part << PartShift) | (2 * sample) | half;
}
