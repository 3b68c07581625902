namespace Msisf.Core.Sky;

/// <summary>The light of a Lambert sphere that is seen from near: of its nearer parts there is more than from far away.</summary>
/// <param name="Light">Light at the observer over that which the distance of the centre alone would give.</param>
/// <param name="Offset">How far the middle of the light is off the centre, towards the side of the Sun, in radii.</param>
public readonly record struct LambertSphere(double Light, double Offset)
{
    /// <summary>Rings of the sphere that are summed; twice as many points are on each. Good to 1e-3 at phases up to 140 degrees.</summary>
    private const int Rings = 128;

    /// <summary>The light of a sphere.</summary>
    /// <param name="phase">rad: Sun, sphere, observer.</param>
    /// <param name="ratio">Its radius over the distance of its centre, below 1.</param>
    public static LambertSphere Of(double phase, double ratio)
    {
        (double sunAside, double sunAlong) = Trigonometry.SinCos(phase);
        double near = 0.0;
        double far = 0.0;
        double aside = 0.0;
        for (int ring = 0; ring < Rings; ring++)
        {
            double height = (((2.0 * ring) + 1.0) / Rings) - 1.0;
            double width = Math.Sqrt(1.0 - (height * height));
            for (int point = 0; point < 2 * Rings; point++)
            {
                (double y, double x) = Trigonometry.SinCos(Math.PI * (point + 0.5) / Rings);
                (x, y) = (width * x, width * y); // towards the observer, and aside
                double lit = (sunAlong * x) + (sunAside * y);
                if (lit <= 0.0)
                {
                    continue;
                }

                (double alongWay, double asideWay, double upWay) = (1.0 - (ratio * x), -ratio * y, -ratio * height);
                double square = (alongWay * alongWay) + (asideWay * asideWay) + (upWay * upWay);
                double emission = ((x * alongWay) + (y * asideWay) + (height * upWay)) / Math.Sqrt(square);
                double seen = lit * Math.Max(0.0, emission) / square;
                near += seen;
                aside += seen * y;
                far += lit * Math.Max(0.0, x);
            }
        }

        return near > 0.0 ? new LambertSphere(near / far, aside / near) : new LambertSphere(1.0, 1.0);
    }
}
