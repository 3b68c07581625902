using Msisf.App.Settings.Specs;

namespace Msisf.App.DataSets;

/// <summary>What a data set's file asks for (docs/data-sets.md).</summary>
internal sealed record DataSetSpec
{
    public required string Path { get; init; }

    /// <summary>SHA-256 of the file, hexadecimal.</summary>
    public required string Sha256 { get; init; }

    public required string Name { get; init; }

    /// <summary>What it is for; null if the file does not say it.</summary>
    public string? Description { get; init; }

    /// <summary>Its own licence; null if the file does not say it.</summary>
    public string? Licence { get; init; }

    /// <summary>Chooses the states.</summary>
    public required ulong Seed { get; init; }

    /// <summary>Chooses the noise of the detectors; each image has its own step of it.</summary>
    public required ulong NoiseSeed { get; init; }

    /// <summary>Whether states are at Kronecker's points, or at random.</summary>
    public required bool IsEven { get; init; }

    /// <summary>How the numbers of a state are distributed; those that are not drawn are missing.</summary>
    public required IReadOnlyDictionary<Quantity, Distribution> Distributions { get; init; }

    public required IReadOnlyList<Split> Splits { get; init; }

    /// <summary>Which of the splits each image, or pair, belongs to.</summary>
    public required IReadOnlyList<int> Order { get; init; }

    /// <summary>Whether each image has a second one near it.</summary>
    public required bool HasPairs { get; init; }

    /// <summary>What each image must meet.</summary>
    public required Conditions Accept { get; init; }

    /// <summary>Formats of the index beside CSV.</summary>
    public required IReadOnlyList<string> Indexes { get; init; }

    /// <summary>Licences by the names of files.</summary>
    public required IReadOnlyDictionary<string, string> Licences { get; init; }

    public required OptionValues Options { get; init; }

    public int Images => Order.Count * (HasPairs ? 2 : 1);
}

/// <summary>What each image of a data set must meet.</summary>
/// <param name="Ground">Least part of the image that shows ground.</param>
/// <param name="Lit">Least part of that ground that gets light.</param>
/// <param name="SunElevation">degrees: least and greatest elevation of the Sun over the ground below the camera; null for any.</param>
internal sealed record Conditions(double Ground, double Lit, (double Min, double Max)? SunElevation);
