namespace Msisf.Core.Render.Sampling;

/// <summary>What the trials of a class of pixels measured.</summary>
internal sealed class ClassError
{
    /// <summary>Number of pixels that were tried.</summary>
    public int Pixels { get; set; }

    /// <summary>Sum of the numbers of facets in these pixels.</summary>
    public double Parts { get; set; }

    /// <summary>Sum of the squared errors, levels of 255, with one sample and with each of <see cref="SampleTrials.Choices"/>.</summary>
    public double[] Squares { get; } = new double[SampleTrials.Choices.Length + 1];

    /// <summary>Sum of the squared errors with all samples but one light for each facet.</summary>
    public double MergedSquares { get; set; }

    /// <summary>Sum of the squared errors with the brightness by the areas of the facets, where the class offers it.</summary>
    public double AreaSquares { get; set; }
}
