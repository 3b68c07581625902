namespace Msisf.Core.Ephemeris;

/// <summary>Motion about one mass: ellipse, parabola, hyperbola or a straight line, by universal variables.</summary>
/// <remarks>R. H. Battin, An Introduction to the Mathematics and Methods of Astrodynamics (1999), section 4.5.</remarks>
public static class TwoBody
{
    private const int MaximumSteps = 200;

    /// <summary>Below it the closed forms of c2 and c3 lose digits.</summary>
    private const double SeriesLimit = 0.5;

    private const int SeriesTerms = 12;

    /// <summary>The state some time after, or before.</summary>
    /// <param name="state">At first, relative to the mass.</param>
    /// <param name="gm">Gravitational parameter (GM) of the mass, in units that fit: km^3/s^2 with km; above 0.</param>
    /// <param name="seconds">s.</param>
    /// <exception cref="BadInputException">The position is that of the mass, or the time is too long to be followed.</exception>
    public static StateVector Propagate(StateVector state, double gm, double seconds)
    {
        double radius = state.Position.Length;
        if (!(radius > 0.0 && gm > 0.0 && state.Velocity.IsFinite && double.IsFinite(radius)))
        {
            throw new BadInputException("A state of two bodies needs a position, a velocity and a mass that are finite and not 0.");
        }

        double root = Math.Sqrt(gm);
        double radialRate = Vector3D.Dot(state.Position, state.Velocity) / root;
        double alpha = (2.0 / radius) - (state.Velocity.LengthSquared / gm); // 1 / semi-major axis; below 0 for a hyperbola
        double chi = Anomaly(radius, radialRate, alpha, root * seconds);
        (double c2, double c3) = Stumpff(alpha * chi * chi);
        double f = 1.0 - (chi * chi * c2 / radius);
        double g = seconds - (chi * chi * chi * c3 / root);
        Vector3D position = (f * state.Position) + (g * state.Velocity);
        double newRadius = position.Length;
        double fRate = root * chi * ((alpha * chi * chi * c3) - 1.0) / (newRadius * radius);
        double gRate = 1.0 - (chi * chi * c2 / newRadius);
        return new StateVector(position, (fRate * state.Position) + (gRate * state.Velocity));
    }

    /// <summary>The universal anomaly; the time is a rising function of it, so it is bracketed.</summary>
    private static double Anomaly(double radius, double radialRate, double alpha, double target)
    {
        if (target == 0.0)
        {
            return 0.0;
        }

        double bound = Math.Abs(target) / radius;
        for (int i = 0; i < MaximumSteps && Math.Abs(Time(Math.CopySign(bound, target)).Time) < Math.Abs(target); i++)
        {
            bound *= 2.0;
        }

        (double low, double high) = target > 0.0 ? (0.0, bound) : (-bound, 0.0);
        double chi = 0.5 * (low + high);
        for (int i = 0; i < MaximumSteps; i++)
        {
            (double time, double rate) = Time(chi);
            (low, high) = time < target ? (chi, high) : (low, chi);
            double next = chi - ((time - target) / rate);
            next = next > low && next < high ? next : 0.5 * (low + high);
            if (next == chi || low == high || double.BitIncrement(low) == high)
            {
                return next;
            }

            chi = next;
        }

        return double.IsFinite(chi) ? chi : throw new BadInputException(Invariant(
            $"The motion of two bodies can't be followed so far (1/a = {alpha:R})."));

        (double Time, double Rate) Time(double x)
        {
            double square = x * x;
            (double c2, double c3) = Stumpff(alpha * square);
            double squareC2 = square * c2;
            double ofChi = 1.0 - (alpha * square * c3);
            return (
                (radialRate * squareC2) + ((1.0 - (alpha * radius)) * square * x * c3) + (radius * x),
                squareC2 + (radialRate * x * ofChi) + (radius * (1.0 - (alpha * squareC2))));
        }
    }

    /// <summary>(1 - cos sqrt z) / z and (sqrt z - sin sqrt z) / sqrt z^3, continued to z below 0.</summary>
    private static (double C2, double C3) Stumpff(double z)
    {
        if (Math.Abs(z) < SeriesLimit)
        {
            double c2 = 0.0;
            double c3 = 0.0;
            for (int k = SeriesTerms; k >= 0; k--)
            {
                c2 = (1.0 - (z * c2)) / ((2.0 * k + 1.0) * (2.0 * k + 2.0));
                c3 = (1.0 - (z * c3)) / ((2.0 * k + 2.0) * (2.0 * k + 3.0));
            }

            return (c2, c3);
        }

        double root = Math.Sqrt(Math.Abs(z));
        if (z < 0.0)
        {
            return ((Math.Cosh(root) - 1.0) / -z, (Math.Sinh(root) - root) / (-z * root));
        }

        double half = Trigonometry.Sin(0.5 * root);
        return (2.0 * half * half / z, (root - Trigonometry.Sin(root)) / (z * root));
    }
}
