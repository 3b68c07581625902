namespace Msisf.Core.Illumination;

/// <summary>The light of a place over an interval; times are steps of it. <c>default</c> is a place without light.</summary>
public readonly record struct PlaceLight
{
    /// <summary>Steps with any part of the Sun in view.</summary>
    public int LitSteps { get; init; }

    /// <summary>Mean visible part of the Sun's disc, by area.</summary>
    public double DiscPart { get; init; }

    /// <summary>The longest time without Sun.</summary>
    public StepRun Dark { get; init; }

    /// <summary>The longest time with Sun.</summary>
    public StepRun Light { get; init; }

    /// <summary>Times without Sun that are longer than the limit.</summary>
    public int Nights { get; init; }

    /// <summary>W/m^2 on a horizontal plane.</summary>
    public Irradiance Horizontal { get; init; }

    /// <summary>W/m^2 on a plane that is turned to the Sun.</summary>
    public Irradiance Tracking { get; init; }

    /// <summary>W/m^2 on the chosen plane.</summary>
    public Irradiance Fixed { get; init; }

    /// <summary>Steps with any part of the Earth in view.</summary>
    public int EarthSteps { get; init; }

    /// <summary>Steps with the whole Earth in view.</summary>
    public int WholeEarthSteps { get; init; }

    /// <summary>Steps with parts of both in view.</summary>
    public int BothSteps { get; init; }
}

/// <summary>Steps of an interval that follow each other.</summary>
/// <param name="First">The first one.</param>
/// <param name="Count">How many; 0 for none.</param>
public readonly record struct StepRun(int First, int Count)
{
    /// <summary>The first step after them.</summary>
    public int End => First + Count;
}

/// <summary>Light on a plane.</summary>
/// <param name="Mean">W/m^2, over all steps.</param>
/// <param name="Greatest">W/m^2.</param>
public readonly record struct Irradiance(double Mean, double Greatest);
