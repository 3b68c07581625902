namespace Msisf.TestSupport.Images;

/// <summary>
/// How far the silhouette against the sky is displaced. At each pixel of the lit limb a profile of the linear grey is taken across it, from
/// inside to outside; the edge is where the profile, coming from outside, first reaches half of the truth's mean just inside. The
/// displacement is the image's edge less the truth's, positive outwards.
/// </summary>
/// <param name="Points">Places along the limb; 0 if no lit limb is in the image.</param>
/// <param name="Rms">px.</param>
/// <param name="Largest">px, without its sign; an edge that is not found within the reach counts as the reach.</param>
internal readonly record struct LimbDisplacement(int Points, double Rms, double Largest)
{
    /// <summary>px; to both sides of the limb.</summary>
    public const int Reach = 4;

    private const double Step = 0.125; // px
    private const double PlateauEnd = -1.5; // px: the truth's own edge, one pixel wide and roughened by facets, stays outside
    private const double MinPlateau = 0.02; // linear grey: below it the limb is dark, and its edge is not seen
    private const int Steps = (int)(2 * Reach / Step);

    /// <summary>Measures.</summary>
    /// <param name="coverage">Part of each pixel's samples that show the surface in truth, [y, x], 0 to 1.</param>
    /// <param name="truth">Linear grey, [y, x].</param>
    /// <param name="image">Linear grey, [y, x].</param>
    public static LimbDisplacement Of(double[,] coverage, double[,] truth, double[,] image)
    {
        ImageSize.Check(truth, image);
        int points = 0;
        double squares = 0.0;
        double largest = 0.0;
        const int Border = (2 * Reach) + 1;
        for (int y = Border; y < truth.GetLength(0) - Border; y++)
        {
            for (int x = Border; x < truth.GetLength(1) - Border; x++)
            {
                if (IsLimb(coverage, x, y) && TryMeasure(coverage, truth, image, x, y) is double displacement)
                {
                    points++;
                    squares += displacement * displacement;
                    largest = Math.Max(largest, Math.Abs(displacement));
                }
            }
        }

        return new LimbDisplacement(points, points == 0 ? 0.0 : Math.Sqrt(squares / points), largest);
    }

    private static bool IsLimb(double[,] coverage, int x, int y) =>
        coverage[y, x] >= 0.5
        && (coverage[y - 1, x] < 0.5 || coverage[y + 1, x] < 0.5 || coverage[y, x - 1] < 0.5 || coverage[y, x + 1] < 0.5);

    private static double? TryMeasure(double[,] coverage, double[,] truth, double[,] image, int x, int y)
    {
        (double outX, double outY) = Outwards(coverage, x, y);
        double length = double.Hypot(outX, outY);
        if (length == 0.0)
        {
            return null; // a speck: surface on all sides alike
        }

        Span<double> ofTruth = stackalloc double[Steps + 1];
        Span<double> ofImage = stackalloc double[Steps + 1];
        for (int i = 0; i <= Steps; i++)
        {
            double atX = x + (Place(i) * outX / length);
            double atY = y + (Place(i) * outY / length);
            ofTruth[i] = At(truth, atX, atY);
            ofImage[i] = At(image, atX, atY);
        }

        double plateau = Plateau(ofTruth);
        return plateau < MinPlateau ? null : Edge(ofImage, 0.5 * plateau) - Edge(ofTruth, 0.5 * plateau);
    }

    private static double Place(double step) => (step * Step) - Reach;

    /// <summary>Away from the middle of the surface around.</summary>
    private static (double X, double Y) Outwards(double[,] coverage, int x, int y)
    {
        double outX = 0.0;
        double outY = 0.0;
        for (int dy = -Reach; dy <= Reach; dy++)
        {
            for (int dx = -Reach; dx <= Reach; dx++)
            {
                outX -= dx * coverage[y + dy, x + dx];
                outY -= dy * coverage[y + dy, x + dx];
            }
        }

        return (outX, outY);
    }

    private static double Plateau(ReadOnlySpan<double> profile)
    {
        int count = (int)((PlateauEnd + Reach) / Step) + 1;
        double sum = 0.0;
        foreach (double value in profile[..count])
        {
            sum += value;
        }

        return sum / count;
    }

    private static double Edge(ReadOnlySpan<double> profile, double half)
    {
        for (int i = profile.Length - 1; i >= 0; i--)
        {
            if (profile[i] >= half)
            {
                // Between this place and the one outside of it, which is darker.
                return i == profile.Length - 1 ? Reach : Place(i + ((profile[i] - half) / (profile[i] - profile[i + 1])));
            }
        }

        return -Reach;
    }

    /// <summary>Between the four pixel centres around.</summary>
    private static double At(double[,] values, double x, double y)
    {
        int left = (int)Math.Floor(x);
        int top = (int)Math.Floor(y);
        double right = x - left;
        double down = y - top;
        return ((1.0 - down) * (((1.0 - right) * values[top, left]) + (right * values[top, left + 1])))
            + (down * (((1.0 - right) * values[top + 1, left]) + (right * values[top + 1, left + 1])));
    }
}
