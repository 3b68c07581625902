using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Visibility;

namespace Msisf.Core.Render.Sampling;

/// <summary>
/// Some pixels of each class that get all samples, each with light of its own, and again with one light for each facet: they tell how far
/// off fewer samples are in this frame.
/// </summary>
internal sealed class SampleTrials
{
    /// <summary>Numbers of vectors of samples among which is chosen, after none.</summary>
    public static readonly int[] Choices = [1, 2, 4, 8];

    private static readonly int Merged = Choices.Length + 1;
    private static readonly int ByAreas = Choices.Length + 2;

    private readonly Dictionary<int, int> _indices = [];
    private readonly double[][] _means = [[], [], [], [], [], [], []];
    private double[] _parts = [];

    /// <summary>The pixels, in their order.</summary>
    public List<int> Pixels { get; private set; } = [];

    /// <summary>Starts with the brightness of the pixels' centres, and that by the areas of their facets.</summary>
    public void Begin(List<int> pixels, ReadOnlySpan<double> radianceFactors, ReadOnlySpan<double> byAreas)
    {
        Pixels = pixels;
        _indices.Clear();
        _parts = new double[pixels.Count];
        for (int i = 0; i < _means.Length; i++)
        {
            _means[i] = new double[pixels.Count];
        }

        for (int i = 0; i < pixels.Count; i++)
        {
            _indices[pixels[i]] = i;
            _means[0][i] = radianceFactors[pixels[i]];
            _means[ByAreas][i] = byAreas[pixels[i]];
        }
    }

    /// <summary>Takes the brightness of a band's facets. Several threads may call it with different bands.</summary>
    public void TakeMerged(PixelParts parts, ReadOnlySpan<double> factors)
    {
        for (int part = 0; part < parts.Count; part++)
        {
            int index = _indices[parts.Pixels[part]];
            _parts[index]++;
            _means[Merged][index] += parts.Weights[part] * factors[part];
        }
    }

    /// <summary>Takes the brightness of each sample of a band. Several threads may call it with different bands.</summary>
    /// <param name="parts">The parts, each sample a receiver.</param>
    /// <param name="factors">The brightness of the parts.</param>
    /// <param name="indirect">The part of it that the ground's own light makes; empty for none.</param>
    /// <param name="fractions">The visible fraction of the light at each receiver.</param>
    public void TakeSamples(
        PixelParts parts, ReadOnlySpan<double> factors, ReadOnlySpan<double> indirect, ReadOnlySpan<double> fractions)
    {
        int receiver = 0;
        for (int part = 0; part < parts.Count; part++)
        {
            int index = _indices[parts.Pixels[part]];
            ReadOnlySpan<double> ofPart = fractions[receiver..parts.ReceiverEnds[part]];
            double lit = 0.0;
            foreach (double fraction in ofPart)
            {
                lit += fraction;
            }

            double ofGround = indirect.IsEmpty ? 0.0 : indirect[part];
            double ofWholeLight = lit > 0.0 ? (factors[part] - ofGround) * ofPart.Length / lit : 0.0;
            foreach (double fraction in ofPart)
            {
                TakeSample(index, parts.Samples[receiver] / SamplePattern.Lanes, ofGround + (fraction * ofWholeLight));
                receiver++;
            }
        }
    }

    private void TakeSample(int index, int vector, double factor)
    {
        for (int i = 0; i < Choices.Length; i++)
        {
            if (vector < Choices[i])
            {
                _means[i + 1][index] += factor / (Choices[i] * SamplePattern.Lanes);
            }
        }
    }

    /// <summary>Sums up what was measured.</summary>
    /// <param name="chooser">Knows the classes.</param>
    /// <param name="grey">From radiance factors to levels of 65535.</param>
    /// <returns>One result for each class.</returns>
    public ClassError[] Sum(SampleChooser chooser, GreyTable grey)
    {
        ushort[][] levels = [.. _means.Select(means =>
        {
            ushort[] converted = new ushort[means.Length];
            grey.Convert(means, converted);
            return converted;
        })];
        ClassError[] sums = [.. Enumerable.Range(0, PixelClass.Count).Select(_ => new ClassError())];
        for (int i = 0; i < Pixels.Count; i++)
        {
            ClassError sum = sums[chooser.ClassOf(Pixels[i])];
            int truth = levels[Choices.Length][i];
            sum.Pixels++;
            sum.Parts += _parts[i];
            for (int choice = 0; choice < sum.Squares.Length; choice++)
            {
                sum.Squares[choice] += Square(levels[choice][i] - truth);
            }

            sum.MergedSquares += Square(levels[Merged][i] - truth);
            sum.AreaSquares += Square(levels[ByAreas][i] - truth);
        }

        return sums;
    }

    private static double Square(int fineLevels)
    {
        double levels = fineLevels / 257.0; // levels of 65535 in one of 255
        return levels * levels;
    }
}

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
