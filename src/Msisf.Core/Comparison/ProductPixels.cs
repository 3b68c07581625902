namespace Msisf.Core.Comparison;

/// <summary>Which pixels of a drawn image make those of a product: parts of it, means of several, framelets with gaps. Immutable.</summary>
/// <param name="Samples">px: width of the product.</param>
/// <param name="Lines">px: its height.</param>
/// <param name="FirstSample">Sample of the drawn image with which the product begins, from 0.</param>
/// <param name="SampleStep">Samples that make one of the product.</param>
/// <param name="LineStep">Lines that make one of the product.</param>
/// <param name="Rows">For each line that makes one of the product, the row of the drawn image; -1 for one that is not drawn.</param>
public sealed record ProductPixels(
    int Samples, int Lines, int FirstSample, int SampleStep, int LineStep, IReadOnlyList<int> Rows)
{
    /// <summary>The means that are the product's pixels.</summary>
    /// <param name="drawn">By rows; NaN where no surface is seen.</param>
    /// <param name="width">Width of the drawn image, px.</param>
    /// <param name="ofSky">What counts in place of NaN; NaN to leave it out.</param>
    /// <returns>By lines of the product; NaN where nothing is drawn.</returns>
    public float[] Means(ReadOnlySpan<double> drawn, int width, double ofSky)
    {
        float[] means = new float[checked(Samples * Lines)];
        double[] sums = new double[Samples];
        int[] counts = new int[Samples];
        for (int line = 0; line < Lines; line++)
        {
            Array.Clear(sums);
            Array.Clear(counts);
            for (int of = line * LineStep; of < (line + 1) * LineStep; of++)
            {
                if (Rows[of] >= 0)
                {
                    Add(drawn.Slice(checked(Rows[of] * width), width), ofSky, sums, counts);
                }
            }

            for (int sample = 0; sample < Samples; sample++)
            {
                means[(line * Samples) + sample] = (float)(sums[sample] / counts[sample]);
            }
        }

        return means;
    }

    private void Add(ReadOnlySpan<double> row, double ofSky, double[] sums, int[] counts)
    {
        for (int i = 0; i < Samples * SampleStep; i++)
        {
            double value = double.IsNaN(row[FirstSample + i]) ? ofSky : row[FirstSample + i];
            if (!double.IsNaN(value))
            {
                sums[i / SampleStep] += value;
                counts[i / SampleStep]++;
            }
        }
    }
}
