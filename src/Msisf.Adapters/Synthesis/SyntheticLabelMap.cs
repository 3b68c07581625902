namespace Msisf.Adapters.Synthesis;

/// <summary>The map projection in the label of a synthetic product; latitudes and longitudes in degrees.</summary>
internal sealed record SyntheticLabelMap
{
    /// <summary>The archive's file that describes the projection.</summary>
    public required string Catalogue { get; init; }

    /// <summary>MAP_PROJECTION_TYPE.</summary>
    public required string Projection { get; init; }

    /// <summary>Samples a degree, as text.</summary>
    public required string Resolution { get; init; }

    /// <summary>m a sample, as text.</summary>
    public required string Scale { get; init; }

    /// <summary>Latitude of the projection's centre.</summary>
    public required int CentreLatitude { get; init; }

    /// <summary>Longitude of the projection's centre.</summary>
    public required int CentreLongitude { get; init; }

    /// <summary>The map's northern border.</summary>
    public required double North { get; init; }

    /// <summary>The map's southern border.</summary>
    public required double South { get; init; }

    /// <summary>The map's western border.</summary>
    public required int West { get; init; }

    /// <summary>The map's eastern border.</summary>
    public required int East { get; init; }

    /// <summary>Lines from the product's first pixel to the projection's centre.</summary>
    public required double LineOffset { get; init; }

    /// <summary>Samples from the product's first pixel to the projection's centre.</summary>
    public required double SampleOffset { get; init; }
}
