using Msisf.Core.Terrain;

namespace Msisf.Adapters.Synthesis;

/// <summary>Makes the label of a synthetic polar map.</summary>
internal static class SyntheticMapLabel
{
    /// <summary>Describes a map.</summary>
    /// <param name="options">What is described, and how it was made.</param>
    public static SyntheticLabel Of(SyntheticMapOptions options)
    {
        int pole = options.IsSouth ? -90 : 90;
        double border = options.IsSouth ? -options.LatitudeDegrees : options.LatitudeDegrees;
        double resolution = MoonConstants.ReferenceRadius * Math.PI / 180.0 / options.MetresPerPixel;
        string scale = options.MetresPerPixel.ToString("R", CultureInfo.InvariantCulture);
        string source = options.Base is null ? "nothing (a made-up global shape)" : options.Base.ProductId;
        return new SyntheticLabel
        {
            ProductId = options.ProductId,
            Description = Invariant($"""
                   A shape map (radius) of a Moon at a scale of {scale} m/pix,
                   computed from the seed
                   {options.Seed}, continuing
                   {source},
                   downwards with random craters and roughness that follow the Moon's
                   statistics, in polar stereographic projection, true to scale at the
                   pole. Map values are relative to a radius of 1737.4 km.
                """),
            Lines = options.Side,
            LineSamples = options.Side,
            Format = options.Format,
            Map = new SyntheticLabelMap
            {
                Catalogue = "DSMAP_POLAR.CAT",
                Projection = "POLAR STEREOGRAPHIC",
                Resolution = resolution.ToString("0.0000", CultureInfo.InvariantCulture),
                Scale = scale,
                CentreLatitude = pole,
                CentreLongitude = 0,
                North = Math.Max(pole, border),
                South = Math.Min(pole, border),
                West = 0,
                East = 360,
                LineOffset = options.Projection.LineOffset,
                SampleOffset = options.Projection.SampleOffset,
            },
        };
    }
}
