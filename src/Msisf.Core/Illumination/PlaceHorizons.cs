namespace Msisf.Core.Illumination;

/// <summary>Horizons of places, with what else of the ground is asked for.</summary>
/// <param name="Radii">m: distances of the places from the body's centre; 0 where the models have no ground.</param>
/// <param name="Slopes">Tangent of the ground's slope; NaN where there is none.</param>
/// <param name="Ends">Where the corners of each place end in <paramref name="Corners"/>.</param>
/// <param name="Corners">Corners between which the horizon is straight.</param>
public sealed record PlaceHorizons(double[] Radii, float[] Slopes, int[] Ends, uint[] Corners)
{
    /// <summary>Whether the models have ground below a place.</summary>
    public bool HasGround(int place) => Radii[place] > 0.0;

    /// <summary>The corners of a place.</summary>
    public ReadOnlySpan<uint> CornersOf(int place)
    {
        int start = place == 0 ? 0 : Ends[place - 1];
        return Corners.AsSpan(start, Ends[place] - start);
    }

    /// <summary>Whether each place has corners from the first column to the last.</summary>
    public bool IsSound
    {
        get
        {
            int start = 0;
            foreach (int end in Ends)
            {
                if (end < start + 2 || end > Corners.Length || Corners[start] >> 16 != 0
                    || Corners[end - 1] >> 16 != HorizonSurvey.Columns - 1)
                {
                    return false;
                }

                for (int corner = start + 1; corner < end - 1; corner++)
                {
                    if (Corners[corner] >> 16 <= Corners[corner - 1] >> 16 || Corners[corner] >> 16 >= HorizonSurvey.Columns)
                    {
                        return false;
                    }
                }

                start = end;
            }

            return start == Corners.Length;
        }
    }
}
