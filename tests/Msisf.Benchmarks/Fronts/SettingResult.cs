using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Programs;
using Msisf.TestSupport.Images;

namespace Msisf.Benchmarks.Fronts;

/// <summary>What a way to make an image costs, and how wrong its image is.</summary>
internal sealed record SettingResult
{
    public required Setting Setting { get; init; }

    /// <summary>
    /// s, from the start of the process to its end, all files written, patterns in place; scaled if <see cref="IsScaled"/>.
    /// </summary>
    public required Samples Seconds { get; init; }

    /// <summary>Of the last run; not scaled.</summary>
    public required RunTiming Timing { get; init; }

    /// <summary>s, of the first run, which made what patterns were missing.</summary>
    public required double FirstSeconds { get; init; }

    /// <summary>Bytes; POV-Ray's, 0 without it or where the system does not tell.</summary>
    public required double PovRayPeakBytes { get; init; }

    /// <summary>Null without POV-Ray.</summary>
    public required PatternFolder? Patterns { get; init; }

    /// <summary>Tiles that the image takes; more than were measured if <see cref="IsScaled"/>.</summary>
    public required int Tiles { get; init; }

    /// <summary>Tiles that were measured.</summary>
    public required int MeasuredTiles { get; init; }

    /// <summary>Null if only a part of the image was made, or the truth is not drawn.</summary>
    public required ImageError? Error { get; init; }

    /// <summary>Null if it was not measured.</summary>
    public required HitDistance? Hits { get; init; }

    /// <summary>Only some of the tiles were measured, and the time is that of all: parsing grows with the number of tiles.</summary>
    public bool IsScaled => MeasuredTiles < Tiles;

    /// <summary>Bytes of all the image's patterns; scaled if <see cref="IsScaled"/>.</summary>
    public double PatternBytes => Patterns is null ? 0.0 : Scale * Patterns.Bytes;

    /// <summary>Triangles of all the image's patterns; scaled if <see cref="IsScaled"/>.</summary>
    public double Triangles => Patterns is null ? 0.0 : Scale * Patterns.Triangles;

    private double Scale => MeasuredTiles == 0 ? 1.0 : (double)Tiles / MeasuredTiles;
}
