using Msisf.Core.Navigation;

namespace Msisf.Core.Tests.Navigation;

/// <summary>Catalogues of craters all over the Moon, the same for the same seed.</summary>
internal static class RandomCraters
{
    /// <summary>Craters of 2 to 400 km, most of them small, as ellipses that lie in all directions.</summary>
    public static Crater[] Make(int seed, int count)
    {
        Random random = new(seed);
        double Between(double low, double high) => low + ((high - low) * random.NextDouble());
        return
        [
            .. Enumerable.Range(1, count).Select(number =>
            {
                double diameter = 2e3 / Math.Sqrt(Between(2.5e-5, 1.0));
                return new Crater(
                    number, $"c{number}", null, double.RadiansToDegrees(Math.Atan(Math.Tan(Math.PI * Between(-0.499, 0.499)))),
                    Between(0.0, 360.0), diameter)
                {
                    MinorDiameter = diameter * Between(0.6, 1.0),
                    AngleDegrees = Between(0.0, 180.0),
                };
            }),
        ];
    }
}
