"""The papers and books behind the calculations, as answers and examples cite them."""

YANCHEVSKY_2018 = (
    "Yanchevsky, Komada, Stelmakh, Lytvynenko 2018, doi 10.20535/1810-0546.2018.1.121166"
)
YANCHEVSKIY_2021 = "Yanchevskiy, Niekhoroshykh 2021, doi 10.20535/kpissn.2021.4.245103"
ZYL = "Zyl, Belarusian-Russian University: forces in the parallel-crank mechanism"
OVSYANNIKOV_2019 = (
    "Ovsyannikov, Perminov, Glavatskikh, Saltykova 2019, doi 10.22213/2413-1172-2019-2-39-46"
)
KHATETOVSKY_2020 = "Khatetovsky, Dokonov, Galyuzhin 2020, UDC 621.833"
PERSSON_1964 = "Persson 1964, On the stress distribution of cylindrical elastic bodies in contact"
JOHNSON_1985 = "Johnson 1985, Contact Mechanics"
WANG_2016 = "Wang, Luo, Su 2016: output mechanism of the cycloidal drive, eq. 5"
HARRIS = "Harris, Rolling Bearing Analysis: Palmgren's approach of rollers"
SHIGLEY = (
    "Budynas, Nisbett: Shigley's Mechanical Engineering Design, 9th (2011) and 11th edition, ch. 6"
)
ISO_281 = "ISO 281:2007, Rolling bearings: dynamic load ratings and rating life"
ISO_6336 = "ISO 6336-2 and ISO 6336-5, Load capacity of gears: pitting, strength of materials"
ISO_286 = "ISO 286-1:2010, ISO code system for tolerances on linear sizes"
JANSEN_1999 = "Jansen 1999, Analysis of variance designs for model output"
ARCHARD_1953 = "Archard 1953, Contact and Rubbing of Flat Surfaces"
