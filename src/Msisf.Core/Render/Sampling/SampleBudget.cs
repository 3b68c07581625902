using Msisf.Core.Render.Visibility;

namespace Msisf.Core.Render.Sampling;

/// <summary>Spreads samples over classes of pixels so that the cheapest of them give the error that is asked for.</summary>
internal static class SampleBudget
{
    /// <summary>Part of the squared error that is planned: the rest is for the error of a measured error.</summary>
    private const double Planned = 0.75;

    /// <summary>Trials whose weight the expectation has against what was measured.</summary>
    private const double ExpectedTrials = 8.0;

    /// <summary>Cost of a pixel, of a sample, and of finding light and brightness of a part, in any unit. Measured.</summary>
    private const double PixelCost = 6.0;

    private const double SampleCost = 1.0;

    private const double PartCost = 2.5;

    /// <summary>Cost of the brightness by areas, which is computed anyway: less than that of any sample.</summary>
    private const double AreaCost = 0.01;

    /// <summary>Steps by which the price of the error is found.</summary>
    private const int Steps = 60;

    /// <summary>Expected error over the contrast, with one sample and with each of the choices: what the front scenes have.</summary>
    private static readonly double[] Expected = [0.17, 0.04, 0.023, 0.015, 0.0];

    /// <summary>The same by the areas of the facets.</summary>
    private const double ExpectedByAreas = 0.03;

    /// <summary>The code of pixels without further samples that get the brightness by the areas of their facets.</summary>
    public const byte Areas = 0x40;

    /// <summary>Chooses the code of each class for <see cref="SampledPixels.Codes"/>.</summary>
    /// <param name="histogram">Number of pixels of each class.</param>
    /// <param name="errors">What was measured of each class.</param>
    /// <param name="error">Rms error that is asked for, levels of 255.</param>
    public static byte[] CodesOf(ReadOnlySpan<int> histogram, IReadOnlyList<ClassError> errors, double error)
    {
        int minContrast = MinContrast(error);
        double pixels = 0.0;
        Option[][] options = new Option[histogram.Length][];
        for (int i = 0; i < histogram.Length; i++)
        {
            pixels += histogram[i];
            options[i] = [.. OptionsOf(errors[i], i, minContrast)];
        }

        double allowed = Planned * error * error * pixels;
        double low = 1e-12; // squared levels for a unit of cost: so little that all pixels get all samples
        double high = 1e12;
        byte[] best = Choose(histogram, options, low, out _);
        for (int step = 0; step < Steps; step++) // the error jumps with the price: no root for MathNet to find
        {
            double price = Math.Sqrt(low * high);
            byte[] choice = Choose(histogram, options, price, out double squares);
            if (squares <= allowed)
            {
                (low, best) = (price, choice);
            }
            else
            {
                high = price;
            }
        }

        return best;
    }

    /// <summary>The smallest contrast of a class whose expected error with one sample may matter.</summary>
    /// <param name="error">Rms error that is asked for, levels of 255.</param>
    public static int MinContrast(double error) => Enumerable.Range(0, PixelClass.Count).Select(PixelClass.MinContrastOf)
        .Where(contrast => contrast <= Math.Max(1.0, error / Expected[0])).Max();

    /// <summary>The squared error with one sample that is expected of a class, levels of 255.</summary>
    public static double ExpectedSquare(int pixelClass) => Math.Pow(Expected[0] * PixelClass.ContrastOf(pixelClass), 2.0);

    private static byte[] Choose(ReadOnlySpan<int> histogram, Option[][] options, double price, out double squares)
    {
        byte[] codes = new byte[histogram.Length];
        squares = 0.0;
        for (int i = 0; i < codes.Length; i++)
        {
            Option best = options[i].MinBy(option => option.Square + (price * option.Cost));
            codes[i] = best.Code;
            squares += histogram[i] * best.Square;
        }

        return codes;
    }

    private static IEnumerable<Option> OptionsOf(ClassError measured, int pixelClass, int minContrast)
    {
        double contrast = PixelClass.ContrastOf(pixelClass);
        double Mean(double squares, double expected) =>
            (squares + (ExpectedTrials * expected * expected * contrast * contrast)) / (measured.Pixels + ExpectedTrials);
        double Square(int choice) => Mean(measured.Squares[choice], Expected[choice]);

        double merged = measured.MergedSquares / (measured.Pixels + ExpectedTrials);
        double parts = Math.Max(1.0, measured.Parts / Math.Max(measured.Pixels, 1));
        yield return new Option(0, Square(0), 0.0);
        if (PixelClass.FacetsOf(pixelClass) != FacetsAround.Other && PixelClass.MinContrastOf(pixelClass) >= minContrast)
        {
            yield return new Option(Areas, Mean(measured.AreaSquares, ExpectedByAreas), AreaCost);
        }

        for (int i = 0; i < SampleTrials.Choices.Length; i++)
        {
            double samples = SampleTrials.Choices[i] * SamplePattern.Lanes;
            double cost = PixelCost + (SampleCost * samples);
            byte code = (byte)SampleTrials.Choices[i];
            yield return new Option(code, Square(i + 1) + merged, cost + (PartCost * Math.Min(parts, samples)));
            yield return new Option((byte)(code | SampledPixels.HasBorder), Square(i + 1), cost + (PartCost * samples));
        }
    }

    /// <summary>What a pixel of a class can get.</summary>
    /// <param name="Square">Squared error, levels of 255.</param>
    private readonly record struct Option(byte Code, double Square, double Cost);
}
