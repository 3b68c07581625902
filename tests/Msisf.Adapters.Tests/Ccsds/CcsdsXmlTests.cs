using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Orbit;
using Xunit;

namespace Msisf.Adapters.Tests.Ccsds;

public sealed class CcsdsXmlTests
{
    private const string Oem = """
        <?xml version="1.0" encoding="UTF-8"?>
        <oem id="CCSDS_OEM_VERS" version="2.0">
          <header><CREATION_DATE>2024-01-18T00:00:00</CREATION_DATE><ORIGINATOR>TEST</ORIGINATOR></header>
          <body>
            <segment>
              <metadata>
                <OBJECT_NAME>ORBITER</OBJECT_NAME>
                <OBJECT_ID>2024-001A</OBJECT_ID>
                <CENTER_NAME>MOON</CENTER_NAME>
                <REF_FRAME>EME2000</REF_FRAME>
                <TIME_SYSTEM>UTC</TIME_SYSTEM>
                <START_TIME>2024-01-19T12:00:00.000</START_TIME>
                <STOP_TIME>2024-01-19T12:01:00.000</STOP_TIME>
                <INTERPOLATION>HERMITE</INTERPOLATION>
                <INTERPOLATION_DEGREE>3</INTERPOLATION_DEGREE>
              </metadata>
              <data>
                <COMMENT>two states</COMMENT>
                <stateVector>
                  <EPOCH>2024-01-19T12:00:00.000</EPOCH>
                  <X units="km">2000.0</X><Y>0.0</Y><Z>0.0</Z>
                  <X_DOT units="km/s">1.0</X_DOT><Y_DOT>0.0</Y_DOT><Z_DOT>0.0</Z_DOT>
                </stateVector>
                <stateVector>
                  <EPOCH>2024-01-19T12:01:00.000</EPOCH>
                  <X>2060.0</X><Y>1.0</Y><Z>0.0</Z>
                  <X_DOT>1.0</X_DOT><Y_DOT>0.0333333333333</Y_DOT><Z_DOT>0.0</Z_DOT>
                </stateVector>
                <covarianceMatrix><EPOCH>2024-01-19T12:00:00.000</EPOCH><CX_X>0.3</CX_X></covarianceMatrix>
              </data>
            </segment>
          </body>
        </oem>
        """;

    private const string Aem = """
        <?xml version="1.0" encoding="UTF-8"?>
        <aem id="CCSDS_AEM_VERS" version="1.0">
          <header><CREATION_DATE>2024-01-18T00:00:00</CREATION_DATE><ORIGINATOR>TEST</ORIGINATOR></header>
          <body>
            <segment>
              <metadata>
                <OBJECT_NAME>ORBITER</OBJECT_NAME>
                <REF_FRAME_A>EME2000</REF_FRAME_A>
                <REF_FRAME_B>SC_BODY_1</REF_FRAME_B>
                <ATTITUDE_DIR>A2B</ATTITUDE_DIR>
                <TIME_SYSTEM>UTC</TIME_SYSTEM>
                <ATTITUDE_TYPE>TYPE</ATTITUDE_TYPE>
                KEYS
              </metadata>
              <data>
                <attitudeState>STATE</attitudeState>
              </data>
            </segment>
          </body>
        </aem>
        """;

    private const string Epoch = "<EPOCH>2024-01-19T12:00:00</EPOCH>";

    [Fact]
    public void ReadOem_Xml_IsTheSameAsLines()
    {
        StateVector ofLines = CcsdsTexts.ReadOem(CcsdsTexts.Oem)[0].Samples[1];
        List<string> notes = [];

        StateSamples samples = Assert.Single(CcsdsTexts.ReadOem(Oem, notes)).Samples;

        Assert.Equal(2, samples.Count);
        Assert.Equal(ofLines, samples[1]);
        Assert.Equal(new Interpolation(InterpolationMethod.Hermite, 3), samples.Interpolation);
        Assert.Empty(notes);
    }

    /// <summary>A combined message may hold several.</summary>
    [Fact]
    public void ReadOem_CombinedMessage_TakesEachOem()
    {
        string oem = Oem[Oem.IndexOf("<oem", StringComparison.Ordinal)..];
        string text = $"<?xml version=\"1.0\"?><ndm><aem><body/></aem>{oem}{oem}</ndm>";

        Assert.Equal(2, CcsdsTexts.ReadOem(text).Count);
    }

    [Theory]
    [InlineData(
        "QUATERNION", "<QUATERNION_TYPE>FIRST</QUATERNION_TYPE>",
        "<quaternionState>EPOCH<quaternion><QC>0.70710678</QC><Q1>0</Q1><Q2>0</Q2><Q3>0.70710678</Q3></quaternion></quaternionState>")]
    [InlineData(
        "QUATERNION/DERIVATIVE", "<QUATERNION_TYPE>LAST</QUATERNION_TYPE>",
        "<quaternionDerivative>EPOCH<quaternion><Q1>0</Q1><Q2>0</Q2><Q3>0.70710678</Q3><QC>0.70710678</QC></quaternion><quaternionRate>"
            + "<Q1_DOT units=\"1/s\">0</Q1_DOT><Q2_DOT>0</Q2_DOT><Q3_DOT>0</Q3_DOT><QC_DOT>0</QC_DOT>"
            + "</quaternionRate></quaternionDerivative>")]
    [InlineData(
        "EULER_ANGLE", "<EULER_ROT_SEQ>312</EULER_ROT_SEQ>",
        "<eulerAngle>EPOCH<rotationAngles><rotation1 angle=\"Z_ANGLE\" units=\"deg\">90</rotation1>"
            + "<rotation2 angle=\"X_ANGLE\">0</rotation2><rotation3 angle=\"Y_ANGLE\">0</rotation3></rotationAngles></eulerAngle>")]
    public void ReadAem_Xml_IsTheSameAttitude(string type, string keys, string state)
    {
        string text = Aem.Replace(">TYPE<", $">{type}<", StringComparison.Ordinal).Replace("KEYS", keys, StringComparison.Ordinal)
            .Replace("STATE", state.Replace("EPOCH", Epoch, StringComparison.Ordinal), StringComparison.Ordinal);

        UnitQuaternion frameFromBody = Assert.Single(CcsdsTexts.ReadAem(text)).Samples.At(CcsdsTexts.Noon);

        Assert.InRange(((frameFromBody * Vector3D.UnitX) - Vector3D.UnitY).Length, 0.0, 1e-8); // the quaternion has 8 decimals
    }

    [Theory]
    [InlineData("units=\"km\"", "units=\"m\"", "orbit.oem, line 21: X is in 'm'; the standard has km.")]
    [InlineData("<Y>0.0</Y>", "", "orbit.oem, line 23: a <stateVector> above is not complete. Complete or remove it.")]
    [InlineData("<Y>0.0</Y>", "<W>0.0</W>", "orbit.oem, line 21: 'W' is not known in <stateVector>.")]
    [InlineData("<Y>0.0</Y>", "<Y>inf</Y>", "orbit.oem, line 21: 'inf' is not finite")]
    [InlineData("<Y>0.0</Y>", "<Y>0.0</Q>", "orbit.oem, line 21: this is not valid XML:")]
    [InlineData("version=\"2.0\"", "", "orbit.oem, line 2: CCSDS_OEM_VERS = '': versions 1.0, 2.0, 3.0 are read.")]
    [InlineData("<CENTER_NAME>MOON", "<CENTER_NAME>VENUS", "orbit.oem, line 9: CENTER_NAME = 'VENUS'")]
    [InlineData("<oem", "<!DOCTYPE oem SYSTEM 'x'><oem", "orbit.oem, line 1: this is not valid XML:")]
    [InlineData("12:01:00.000</EPOCH>", "11:01:00.000</EPOCH>", "orbit.oem, line 28: the time is before that of the line above.")]
    public void ReadOem_WrongXml_SaysWhereAndWhat(string right, string wrong, string expected)
    {
        BadInputException failure = Assert.Throws<BadInputException>(
            () => CcsdsTexts.ReadOem(Oem.Replace(right, wrong, StringComparison.Ordinal)));

        Assert.StartsWith(expected, failure.Message);
    }

    [Fact]
    public void ReadAem_XmlOfAnOem_SaysSo() => Assert.StartsWith(
        "turn.aem, line 2: this is not an AEM: it begins with <oem>, <aem> is needed.",
        Assert.Throws<BadInputException>(() => CcsdsTexts.ReadAem(Oem)).Message);
}
